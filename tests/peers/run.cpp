#include "tests/peers/run.h"

#include <time.h>

namespace pushfactor::tests::peers {

namespace {

double cpu_us() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

}  // namespace

Run run_peer(const Setting& setting, const Scene& scene, std::size_t steps) {
    const std::unique_ptr<World> world = setting.build(scene);
    Run run;
    run.joint = setting.joint;
    run.velocity_lag.assign(steps + 1, setting.velocity_lag / setting.substeps);
    run.states.push_back(world->states());
    for (std::size_t n = 0; n < steps; ++n) {
        const double begin = cpu_us();
        world->step();
        run.step_us.push_back(cpu_us() - begin);
        run.states.push_back(world->states());
    }
    return run;
}

}  // namespace pushfactor::tests::peers
