// Allocations: they are counted, and settled steps make none.
#include "demos/reports/cost/cost.h"
#include "engine/base/math.h"
#include "tests/catch.h"
#include "tests/demos/runs/allocations.h"

#include <cstdlib>
#include <memory>
#include <thread>
#include <vector>

using namespace pushfactor;
using namespace pushfactor::demos::reports::cost;
using namespace pushfactor::tests;

namespace {

// The allocations of `act`.
template <typename Act>
Allocations taken_by(Act act) {
    const Allocations before = allocations();
    act();
    return allocations() - before;
}

}  // namespace

TEST_CASE("memory is counted for all code, thread by thread", "[threads]") {
    if (!allocations_are_counted()) return;  // sanitizers have their own malloc
    std::vector<double> standard;
    const Allocations of_standard = taken_by([&] { standard.resize(100); });
    CHECK(of_standard.count == 1);
    CHECK(of_standard.bytes == 800);

    engine::VectorX eigen;
    const Allocations of_eigen = taken_by([&] { eigen.resize(50); });
    CHECK(of_eigen.count == 1);
    CHECK(of_eigen.bytes == 400);

    const Allocations of_kept = taken_by([&] { standard.resize(10); });
    CHECK(of_kept.count == 0);

    Allocations elsewhere;
    const Allocations here = taken_by([&] {
        std::thread other([&] { elsewhere = taken_by([] { std::vector<std::unique_ptr<char[]>>(1000); }); });
        other.join();
    });
    CHECK(elsewhere.bytes == 8000);
    CHECK(here.bytes < 8000);
}

TEST_CASE("a settled step allocates nothing") {
    if (!allocations_are_counted()) return;  // sanitizers have their own malloc
    for (const CostCase& one : cost_cases(true)) {
        if (one.name.ends_with("falling")) continue;
        // Sharing work between threads allocates.
        const auto choices = demos::run_of(one.scene, one.options).on_one_thread();
        const auto moment = moment_at(choices, one.start, [] {});
        const Counts counts = count_steps(moment);
        Walk walk(moment);
        walk.go(Walk::steps_counted);  // until what is solved now and then is planned too
        const Allocations taken = taken_by([&] { walk.go(Walk::steps_counted); });
        INFO(one.name);
        // Pendulums that hold bodies by friction never settle: rows come and go, and their buffers grow now and
        // then.
        const double most = counts.sweeps > 0.0 ? 6.0 * Walk::steps_counted : 0.0;
        CHECK(static_cast<double>(taken.count) <= most);
        CHECK(static_cast<double>(taken.bytes) <= 4096.0 * most);
    }
}
