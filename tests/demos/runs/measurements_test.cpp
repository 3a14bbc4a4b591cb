// How runs are judged, on scenes whose outcome is known.
#include "demos/runs/measurements.h"

#include "demos/base/text/errors.h"
#include "demos/options/named_run.h"
#include "demos/runs/stretch.h"
#include "demos/scenes/named/named_scenes.h"
#include "tests/catch.h"
#include "tests/settings.h"

#include <cmath>
#include <limits>

using namespace pushfactor;
using namespace pushfactor::demos;
using engine::Vector3;

namespace {

Settings settings() {
    return tests::awake_settings("default");
}

// One cube at rest on the ground, to be disturbed by a test.
BuiltScene one_cube() {
    return build_scene(scenes::cube_tower({.count = 1, .gap = 0.0, .ground_gap = -0.001}), settings());
}

struct Judged {
    Outcome outcome;
    std::optional<double> fall_time, lean_time;
    double max_off_axis;
};

Judged judge(BuiltScene scene, double seconds) {
    Simulation simulation(std::move(scene), settings());
    Measurements measurements(simulation);
    for (int i = 0; i < seconds * 60; ++i) {
        simulation.advance();
        measurements.observe(simulation);
    }
    return {measurements.outcome(), measurements.fall_time(), measurements.lean_time(),
            measurements.max_off_axis()};
}

Outcome outcome_of(const SceneDescription& scene, double seconds, const std::string& preset = "default") {
    const Settings settings = tests::awake_settings(preset);
    Simulation simulation(build_scene(scene, settings), settings);
    Measurements measurements(simulation);
    for (int i = 0; i < seconds * 60; ++i) {
        simulation.advance();
        measurements.observe(simulation);
    }
    return measurements.outcome();
}

Outcome outcome_of_chain(const OptionTexts& options) {
    const Choices choices = run_of("chain", options);
    Simulation simulation(choices);
    Measurements measurements(simulation);
    for (long i = 0; i < whole_steps(choices.settings); ++i) {
        simulation.advance();
        measurements.observe(simulation);
    }
    return measurements.outcome();
}

SceneDescription with_ground(const BodyDescription& body) {
    SceneDescription scene;
    scene.name = "one";
    scene.contacts = true;
    scene.bodies = {{.name = "ground", .shape = PlaneShape{}}, body};
    return scene;
}

// A ball of 0.1 m that falls at `speed` [m/s] onto the middle of a plate, or `beside` it [m].
SceneDescription ball_and_plate(double speed, double beside = 0.0) {
    SceneDescription scene;
    scene.name = "plate";
    scene.contacts = true;
    scene.bodies = {{.name = "plate", .shape = BoxShape{Vector3(2, 0.1, 2)}},
                    {.name = "ball",
                     .shape = SphereShape{0.1},
                     .mass = 1.0,
                     .position = Vector3(beside, 1, 0),
                     .velocity = Vector3(0, -speed, 0)}};
    return scene;
}

}  // namespace

TEST_CASE("a cube that is left alone rests") {
    CHECK(judge(one_cube(), 2).outcome == Outcome::rest);
}

TEST_CASE("a cube that is thrown up flies, one that slides moves, one that slips through the ground tunnels") {
    BuiltScene thrown = one_cube();
    thrown.world.bodies[1].linear_momentum = Vector3(0, 30, 0) / thrown.world.bodies[1].inverse_mass;
    CHECK(judge(std::move(thrown), 1).outcome == Outcome::fly);

    BuiltScene sliding = one_cube();
    sliding.world.bodies[1].linear_momentum = Vector3(20, 0, 0) / sliding.world.bodies[1].inverse_mass;
    CHECK(judge(std::move(sliding), 2).outcome == Outcome::moving);

    BuiltScene below = one_cube();
    below.world.constraints.clear();  // nothing holds it
    below.contacts = nullptr;
    const Judged fallen = judge(std::move(below), 1);
    CHECK(fallen.outcome == Outcome::fall);
    REQUIRE(fallen.fall_time);
    // Half a side of 2.4 m in free fall: sqrt(2 1.2 / 10) s = 0.49 s.
    CHECK(*fallen.fall_time == Approx(0.49).margin(0.02));
}

TEST_CASE("a rod that has slid a metre and lies still rests, and one that is still on its way moves") {
    const SceneDescription scene = with_ground({.name = "rod",
                                                .shape = BoxShape{Vector3(1, 0.04, 0.04)},
                                                .mass = 1.0,
                                                .position = Vector3(0, 0.02, 0),
                                                .velocity = Vector3(3.2, 0, 0)});
    CHECK(outcome_of(scene, 0.5) == Outcome::moving);
    CHECK(outcome_of(scene, 3) == Outcome::rest);  // after v^2 / (2 mu g) = 1.02 m, 25 times its thickness
}

TEST_CASE("a free ball that rises above its start flies, one on a bar swings") {
    BodyDescription ball{.name = "ball",
                         .shape = SphereShape{0.1},
                         .mass = 1.0,
                         .position = Vector3(0, 10, 0),
                         .velocity = Vector3(0, 8, 0)};
    CHECK(outcome_of(with_ground(ball), 0.5) == Outcome::fly);
    ball.velocity = Vector3(8, 0, 0);
    SceneDescription swing = with_ground(ball);
    swing.distances = {{.a = {.body = "world", .point = Vector3(0, 12, 0)}, .b = {.body = "ball"}}};
    CHECK(outcome_of(swing, 0.5) == Outcome::moving);
}

TEST_CASE("a chain that whips moves, one whose bars give way is torn") {
    CHECK(outcome_of_chain({{"end-mass", "100"}}) == Outcome::moving);
    CHECK(outcome_of_chain({{"end-mass", "1000"}, {"substeps", "1"}}) == Outcome::torn);
}

TEST_CASE("a ball that goes through a plate tunnels, one that lies on it or passes beside it does not") {
    CHECK(outcome_of(ball_and_plate(200), 2, "paper") == Outcome::tunnel);
    CHECK(outcome_of(ball_and_plate(200), 2) == Outcome::rest);
    CHECK(outcome_of(ball_and_plate(200, 1.11), 2) == Outcome::moving);
    // It rolls off the edge.
    SceneDescription rolls = ball_and_plate(0, 0.5);
    rolls.bodies[1].position.y() = 0.15;
    rolls.bodies[1].velocity = Vector3(2, 0, 0);
    CHECK(outcome_of(rolls, 2) == Outcome::moving);
}

TEST_CASE("a box that turns in its place moves") {
    SceneDescription scene;
    scene.name = "turns";
    scene.gravity = Vector3::Zero();
    scene.bodies = {{.name = "box", .mass = 1.0, .angular_velocity = Vector3(0, 2, 0)}};
    CHECK(outcome_of(scene, 2) == Outcome::moving);
    scene.bodies[0].angular_velocity = Vector3::Zero();
    CHECK(outcome_of(scene, 2) == Outcome::rest);
}

TEST_CASE("a slack rope is not torn, one that holds nothing back is") {
    SceneDescription scene;
    scene.name = "rope";
    scene.bodies = {{.name = "ball", .shape = SphereShape{0.1}, .mass = 1.0, .position = Vector3(0, -0.2, 0)}};
    scene.distances = {
        {.a = {.body = "world"}, .b = {.body = "ball"}, .length = 1.0, .acts = engine::Distance::Acts::pulls}};
    const Settings settings = tests::awake_settings("default");
    BuiltScene built = build_scene(scene, settings);
    CHECK(worst_stretch(built) == 0.0);
    built.world.bodies[0].position.y() = -1.6;
    CHECK(worst_stretch(built) == Approx(0.6));
}

TEST_CASE("lean time is the first moment at half a side sideways") {
    BuiltScene sliding = one_cube();
    sliding.world.bodies[1].linear_momentum = Vector3(20, 0, 0) / sliding.world.bodies[1].inverse_mass;
    const Judged judged = judge(std::move(sliding), 1);
    REQUIRE(judged.lean_time);
    // v t - mu g t^2 / 2 = 1.2 m with v = 20, mu g = 5.
    CHECK(*judged.lean_time == Approx(0.0606).margin(1.0 / 60));
    CHECK(judged.max_off_axis == Approx(20.0 - 2.5).epsilon(0.02));
}

TEST_CASE("a number that is not finite ends the run with body, quantity and step") {
    BuiltScene scene = one_cube();
    scene.world.bodies[1].linear_momentum.x() = std::numeric_limits<double>::quiet_NaN();
    Simulation simulation(std::move(scene), settings());
    CHECK_THROWS_AS(simulation.advance(), NonFiniteError);
    CHECK_THROWS_WITH(simulation.advance(),
                      Catch::Contains("body cube 1") && Catch::Contains("position") && Catch::Contains("step"));
}

TEST_CASE("a run is judged the same with small steps as with large ones") {
    for (const Rational dt : {Rational{1, 60}, Rational{1, 1000}, Rational{1, 30}}) {
        Settings small = settings();
        small.dt = dt;
        BuiltScene sliding = one_cube();
        sliding.world.bodies[1].linear_momentum = Vector3(5.5, 0, 0) / sliding.world.bodies[1].inverse_mass;
        Simulation simulation(std::move(sliding), small);
        Measurements measurements(simulation);
        double after_a_second = 0.0;
        for (long n = 1; n <= std::lround(2.0 / dt.value()); ++n) {
            simulation.advance();
            measurements.observe(simulation);
            if (n == std::lround(1.0 / dt.value())) after_a_second = measurements.max_speed_last_second();
        }
        // It stops after 5.5 / (mu g) = 1.1 s: the first second is fast, the last one begins at 0.5 m/s.
        CHECK(after_a_second == Approx(5.5).margin(0.3));
        CHECK(measurements.max_speed_last_second() == Approx(0.5).margin(0.3));
        CHECK(measurements.max_speed_last_second() > 0.1);
    }
}

TEST_CASE("the median is the middle, or the mean of the two in the middle") {
    CHECK(median({3, 1, 2}) == 2.0);
    CHECK(median({4, 1, 2, 3}) == 2.5);
    CHECK(median({}) == 0.0);
}
