// Random mechanisms with closed loops (random_loops.h), by default: energy, forces at rest, and work of a step.
#include "tests/demos/scenes/random_loops.h"

#include "tests/catch.h"
#include "tests/scene_fixture.h"
#include "tests/settings.h"

#include <algorithm>

using namespace pushfactor;
using namespace pushfactor::demos;
using tests::LoopFamily;

namespace {

constexpr double gravity = 9.81;  // m/s^2

tests::Run start(const SceneDescription& scene) {
    const Settings settings = tests::awake_settings("default");
    return tests::Run(Simulation(build_scene(scene, settings), settings));
}

// Advances the run, and returns the most multiply-adds of a step.
double advance(tests::Run& run, double seconds) {
    double most = 0.0;
    for (long step = std::lround(60.0 * seconds); step > 0; --step) {
        run.advance(1.0 / 60.0);
        most = std::max(most, run.simulation.sample().count.multiply_adds);
    }
    return most;
}

// Calls `visit(family, scene, random)` for the members of these seeds.
template <typename Visit>
void each_member(bool driven, unsigned seeds, const Visit& visit) {
    for (const LoopFamily& family : tests::loop_families()) {
        if (family.driven != driven) continue;
        for (unsigned seed = 0; seed < seeds; ++seed) {
            tests::Random random(seed);
            SceneDescription scene = family.make(random);
            INFO(family.name << ", seed " << seed);
            visit(family, scene, random);
        }
    }
}

constexpr double work_of_20_ms = 8e7;

}  // namespace

// Of 23 of each family none gains anything, and no step takes more than 6.7e7 multiply-adds; of fourteen no force
// is above 0.7 of the weight. The last to tip over, a welded ring, does so after 3.2 s.
TEST_CASE(
    "random rings, scissors, frames and wishbones that drop gain nothing, and lie with less than their weight",
    "[long]") {
    each_member(false, 3, [](const LoopFamily&, SceneDescription& scene, tests::Random& random) {
        drop(scene, random);
        const double weight = gravity * tests::mass_of(scene);
        tests::Run run = start(scene);
        const double work = advance(run, 5.0);
        CHECK(run.measurements.energy_gain() < 1e-6 * run.measurements.initial_energy());
        CHECK(run.measurements.max_length_error() < 0.02);
        CHECK(run.measurements.max_speed_last_second() < 1.0);
        CHECK(tests::largest_joint_force(*run.simulation.scene().joints) < weight);
        CHECK(work < work_of_20_ms);
    });
}

// Measured of 23 of each family: at most 6e-16, and for wishbones 7e-8, in their first step; but of scissors 7 gain
// up to 8e-4 near a dead point, where momenta are cut off. Without the turning of free bodies in the curve trusses
// gain up to all of their energy, and with momenta for all of an error 2e-3.
TEST_CASE("random loops that turn freely gain no energy, whatever the number of substeps does") {
    each_member(false, 6, [](const LoopFamily& family, SceneDescription& scene, tests::Random& random) {
        set_free(scene, random);
        tests::Run run = start(scene);
        advance(run, 5.0);
        // Changes of the number of substeps leave errors of second order: of thirty scissors the worst
        // gains 1.8e-3.
        const double most = family.name == "scissors" ? 2e-3 : 1e-6;
        CHECK(run.measurements.energy_gain() < most * run.measurements.initial_energy());
    });
}

TEST_CASE("random loops driven by a motor gain no more than its work", "[long]") {
    each_member(true, 2, [](const LoopFamily& family, SceneDescription& scene, tests::Random& random) {
        family.anchored ? hang(scene, random) : drop(scene, random);
        const double height = gravity * tests::mass_of(scene) * tests::reach_of(scene);
        tests::Run run = start(scene);
        const double work = advance(run, 4.0);
        CHECK(run.measurements.energy_gain() <
              1e-3 * (family.anchored ? height : run.measurements.initial_energy()));
        CHECK(run.measurements.max_length_error() < 0.02);
        CHECK(work < work_of_20_ms);
    });
}
