// Small bodies and long steps: what stands at 60 Hz stands at any size and step, because small bodies get more
// small steps.
#include "demos/scenes/named/named_scenes.h"
#include "tests/catch.h"
#include "tests/scene_fixture.h"
#include "tests/settings.h"

using namespace pushfactor;
using namespace pushfactor::demos;

namespace {

tests::Run tower_run(double side, int count, Settings settings) {
    scenes::Tower tower{.count = count, .side = side, .mass = 1000.0 * side * side * side};
    tower.gap = tower.ground_gap = -1e-4 * side;
    return tests::Run(Simulation(build_scene(cube_tower(tower), settings), settings));
}

Settings with_step(Rational dt) {
    Settings settings = tests::awake_settings("default");
    settings.dt = dt;
    return settings;
}

}  // namespace

TEST_CASE("towers of cubes of 1 mm, 1 cm, 10 cm and 1 km stand at 60 Hz") {
    for (const double side : {1e-3, 1e-2, 1e-1, 1e3}) {
        tests::Run run = tower_run(side, 5, with_step({1, 60}));
        run.advance(5.0);
        INFO(side << " m: " << name_of(run.measurements.outcome()) << ", penetration "
                  << run.measurements.max_penetration() / side << " of the side");
        CHECK(run.measurements.outcome() == Outcome::rest);
        CHECK(run.measurements.max_penetration() < 0.005 * side);
        CHECK(run.simulation.sample().substeps == 1);
    }
}

TEST_CASE("a stack of five stands at steps of 1/10, 1/30 and 1/1000 s") {
    for (const auto& [dt, seconds] :
         {std::pair{Rational{1, 10}, 60.0}, {Rational{1, 30}, 60.0}, {Rational{1, 1000}, 8.0}}) {
        tests::Run run(tests::simulate("stack", with_step(dt)));
        run.advance(seconds);
        INFO(dt.denominator << ": " << name_of(run.measurements.outcome()) << ", "
                            << run.measurements.max_off_axis() << " m off");
        CHECK(run.measurements.outcome() == Outcome::rest);
        CHECK(!run.measurements.lean_time());
    }
}
