#include "demos/observed_run.h"

#include "demos/summary.h"

#include <ctime>

namespace pushfactor::demos {

double thread_cpu_us() {
    std::timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e6 + static_cast<double>(now.tv_nsec) * 1e-3;
}

ObservedRun::ObservedRun(const Choices& choices, const Request& request)
    : choices_(choices),
      simulation_(choices.build(), choices.settings, request.timing ? thread_cpu_us : nullptr),
      measurements_(simulation_) {
    if (request.csv) records_.push_back(steps_record(*request.csv, request.timing));
    if (request.trajectory) {
        const auto& fps = choices.frames.fps;
        const long every = fps ? steps_a_frame(*fps, choices.settings.dt) : 1;
        records_.push_back(trajectory_record(*request.trajectory, every, simulation_));
    }
    if (request.rows) records_.push_back(rows_record(*request.rows));
}

void ObservedRun::advance() {
    simulation_.advance();
    measurements_.observe(simulation_);
    for (const auto& record : records_) record->observe(simulation_);
}

std::string ObservedRun::finish() {
    for (const auto& record : records_) record->finish();
    return summary_text(choices_, simulation_, measurements_);
}

}  // namespace pushfactor::demos
