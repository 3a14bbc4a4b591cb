// --scheme on the scenes: the wave against its reference, and what is refused.
#include "demos/scenes/exact_motions/ball_on_bar.h"
#include "engine/base/invalid_input.h"
#include "tests/catch.h"
#include "tests/demos/program.h"
#include "tests/scene_fixture.h"
#include "tests/settings.h"

#include <cmath>

using namespace pushfactor;
using namespace pushfactor::demos;
using tests::Run;
using tests::simulate;

namespace {

double wave_error(Scheme scheme, Rational dt, double seconds) {
    Settings settings = tests::solved_exactly(tests::awake_settings("default"));
    settings.scheme = scheme;
    settings.dt = dt;
    Run run(simulate("pendulum-wave", settings, {{"count", "10"}}));
    run.advance(seconds);
    CHECK(run.measurements.max_length_error() < 1e-12);
    return run.measured("angle_error_rms_deg");
}

}  // namespace

TEST_CASE("the wave shows orders 2, 4 and 6 against the two-angle reference") {
    const auto order = [](Scheme scheme) {
        return std::log2(wave_error(scheme, {1, 60}, 10) / wave_error(scheme, {1, 120}, 10));
    };
    CHECK(order(Scheme::rattle) == Approx(2.0).epsilon(0.05));
    CHECK(order(Scheme::rattle4) == Approx(4.0).epsilon(0.05));
    CHECK(order(Scheme::rattle6) == Approx(6.0).epsilon(0.05));
}

TEST_CASE("with the default tolerances the composed integrators follow the wave for a minute") {
    Settings settings = tests::awake_settings("default");
    settings.scheme = Scheme::rattle4;
    Run suzuki(simulate("pendulum-wave", settings));
    suzuki.advance(60);
    CHECK(suzuki.measured("angle_error_rms_deg") < 1e-4);             // measured 7.6e-5
    CHECK(std::abs(suzuki.measured("energy_loss_of_swing")) < 1e-7);  // measured -6.4e-9
    settings.scheme = Scheme::rattle6;
    settings.dt = Rational{1, 90};
    Run yoshida(simulate("pendulum-wave", settings));
    yoshida.advance(60);
    CHECK(yoshida.measured("angle_error_rms_deg") < 2e-6);  // measured 1.8e-6
}

TEST_CASE("the push of distances does not matter to rattle") {
    Settings settings = tests::awake_settings("default");
    settings.scheme = Scheme::rattle;
    const auto place = [](const Settings& chosen) {
        auto simulation = simulate("pendulum-wave", chosen, {{"count", "3"}});
        tests::advance(simulation, 1.0);
        return simulation.scene().world.bodies[0].position;
    };
    Settings other = settings;
    other.distances = {engine::PushKind::single_frame, 0.2};
    CHECK(place(settings) == place(other));
}

TEST_CASE("schemes of bars are refused where they do not fit, in one line") {
    const auto contacts = tests::run_program("run stack --scheme rattle");
    CHECK(contacts.status == 2);
    CHECK_THAT(contacts.err, Catch::Contains("--scheme rattle: must be auto or whole for a scene with contacts\n"));
    const auto kick = tests::run_program("run pendulum-wave --scheme rattle4 --start-kick on");
    CHECK(kick.status == 2);
    CHECK_THAT(kick.err, Catch::Contains("--start-kick on: must be off or auto with --scheme rattle4\n"));
    CHECK(tests::run_program("run pendulum-wave --scheme rattle5").status == 2);

    SceneDescription scene;
    scene.bodies.push_back({.name = "ball", .shape = SphereShape{0.1}, .mass = 1.0});
    scene.distances.push_back({.a = {"world", {0, 1, 0}}, .b = {"ball"}, .acts = engine::Distance::Acts::pulls});
    Settings settings = tests::awake_settings("default");
    settings.scheme = Scheme::rattle6;
    CHECK_THROWS_WITH(build_scene(scene, settings),
                      "--scheme rattle6: must be auto or whole for a scene with ropes or struts");
    scene.distances[0] = {.a = {"world", {0, 1, 0}}, .b = {"ball"}, .max_force = 3.0};
    CHECK_THROWS_WITH(build_scene(scene, settings),
                      "--scheme rattle6: must be auto or whole for a scene with bars that yield");
}

TEST_CASE("a run with another scheme is the same again from its own scene file") {
    const tests::Folder folder;
    const auto made =
        tests::shell(folder,
                     "pushfactor scene pendulum-wave --count 3 --scheme rattle4 > wave.json && "
                     "pushfactor run wave.json --seconds 1 | grep state_hash && "
                     "pushfactor run pendulum-wave --count 3 --scheme rattle4 --seconds 1 | grep state_hash");
    CHECK(made.status == 0);
    const auto middle = made.out.find('\n');
    REQUIRE(middle != std::string::npos);
    CHECK(made.out.substr(0, middle + 1) == made.out.substr(middle + 1));
    CHECK_THAT(folder.read("wave.json"), Catch::Contains("rattle4"));
}
