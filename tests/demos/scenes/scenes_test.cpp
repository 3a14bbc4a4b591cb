// The scenes of paper section 10.3: what they must do. Measured values are next to the bounds.
#include "demos/runs/measurements.h"
#include "demos/scenes/exact_motions/ball_on_bar.h"
#include "engine/bodies/diagnostics.h"
#include "tests/catch.h"
#include "tests/scene_fixture.h"
#include "tests/settings.h"

#include <cmath>
#include <numbers>

using namespace pushfactor;
using namespace pushfactor::demos;
using tests::Run;
using tests::simulate;

TEST_CASE("the balls in the funnel come to rest and none is lost, for several starts") {
    for (const char* seed : {"1", "2", "3"}) {
        Run run(simulate("funnel", tests::awake_settings("default"), {{"seed", seed}}));
        run.advance(30);
        CHECK(run.measurements.outcome() == Outcome::rest);
        CHECK(run.measurements.max_kinetic_energy_last_second() < 1e-6);  // measured 8e-17 J
    }
}

TEST_CASE("under the paper's settings the funnel is reasonably stable") {
    Run run(simulate("funnel", tests::awake_settings("paper")));
    run.advance(30);
    CHECK(run.measurements.max_kinetic_energy_last_second() < 0.1);  // measured 0.015 J at 60 s
    CHECK(run.measurements.outcome() != Outcome::tunnel);
}

TEST_CASE("two hundred balls fall as a heap, not as a tower") {
    auto simulation = simulate("funnel", tests::awake_settings("default"), {{"count", "200"}});
    double highest = 0.0;
    for (const auto& body : simulation.scene().world.bodies) highest = std::max(highest, body.position.y());
    CHECK(highest < 10.0);  // a tower would be 220 m
    CHECK(simulation.sample().penetration.points == 0);
}

TEST_CASE("the pendulum grid holds all five objects for a minute") {
    Run run(simulate("pendulum-grid", tests::awake_settings("default")));
    run.advance(60);
    CHECK(run.measured("on_top") == 5.0);
    CHECK(run.measurements.max_length_error() < 1e-3);
}

TEST_CASE("a poke of 60 N presses one sphere through the grid, the other four stay") {
    Run run(simulate("pendulum-grid", tests::awake_settings("default"), {{"poke", "60"}, {"poke-at", "2"}}));
    run.advance(1.9);
    CHECK(run.measured("on_top") == 5.0);
    run.advance(8.1);
    CHECK(run.measured("on_top") == 4.0);
}

TEST_CASE("the wave follows the two-angle reference: 0.06 degrees at 60 Hz, 0.0025 at 240 Hz, over 60 s") {
    Settings settings = tests::awake_settings("default");
    Run coarse(simulate("pendulum-wave", settings));
    coarse.advance(60);
    CHECK(coarse.measured("angle_error_rms_deg") < 0.06);  // measured 0.0557
    settings.dt = Rational{1, 240};
    Run fine(simulate("pendulum-wave", settings));
    fine.advance(60);
    CHECK(fine.measured("angle_error_rms_deg") < 0.0025);  // measured 0.0022
}

TEST_CASE("without the kick at the start the wave is of first order") {
    Settings settings = tests::awake_settings("default");
    settings.start_kick = StartKick::off;
    Run run(simulate("pendulum-wave", settings));
    run.advance(30);
    CHECK(run.measured("angle_error_rms_deg") > 0.2);
}

TEST_CASE("the wave forms two, three and four groups after 60, 40 and 30 s and is in phase after 120 s") {
    Run run(simulate("pendulum-wave", tests::awake_settings("default")));
    double at = 0.0;
    for (const auto& [time, groups] : {std::pair{30.0, 4}, {40.0, 3}, {60.0, 2}, {120.0, 1}}) {
        run.advance(time - at);
        at = time;
        for (int k = 0; k < 50; ++k) {
            const auto& position = run.simulation.scene().world.bodies[static_cast<std::size_t>(k)].position;
            const double angle = std::atan2(position.z(), 3.2 - position.y());
            const double phase = 2.0 * std::numbers::pi * (40 + k) / groups;
            INFO("time " << time << ", ball " << k);
            CHECK(angle == Approx(0.4 * std::cos(phase)).margin(0.05));
        }
    }
    CHECK(run.measured("energy_loss_of_swing") < 0.01);  // measured 0.0032
    CHECK(run.measured("energy_loss_of_swing") > -0.01);
}

TEST_CASE("the wave has no contact stage, makes no pair and has one column") {
    auto simulation = simulate("pendulum-wave", tests::awake_settings("default"));
    simulation.advance();
    CHECK(simulation.scene().contacts == nullptr);
    CHECK(simulation.scene().world.constraints.size() == 1);
    CHECK(simulation.sample().count.rows() == 50);
    CHECK(simulation.sample().count.rows(engine::RowKind::contact) == 0);
    CHECK(simulation.sample().count.columns == 1);
}

TEST_CASE("the slow mode of a small swing of ball and bar is the root of its characteristic equation") {
    // 0.4 l r w^4 - g (l + 1.4 r) w^2 + g^2 = 0, the smaller root.
    const double g = 10.0, r = 0.1;
    for (const double l : {0.1, 0.3, 1.0, 4.0}) {
        const double sum = l + 1.4 * r;
        const double slow = std::sqrt(g * (sum - std::sqrt(sum * sum - 1.6 * l * r)) / (0.8 * l * r));
        const scenes::BallOnBar pendulum{.length = l, .radius = r, .gravity = g};
        CHECK(2.0 * std::numbers::pi / scenes::period(pendulum, 1e-3) == Approx(slow).epsilon(1e-5));
    }
}

TEST_CASE("the reference does not depend on its step") {
    const scenes::BallOnBar pendulum{.length = 0.5, .radius = 0.1, .gravity = 10.0};
    const scenes::Swing start{.a = 0.4, .b = 0.4};
    const auto coarse = scenes::advance(pendulum, start, 60.0, 60 * 960);
    const auto fine = scenes::advance(pendulum, start, 60.0, 60 * 3840);
    CHECK(centre_angle(pendulum, coarse) == Approx(centre_angle(pendulum, fine)).margin(1e-6));
}

TEST_CASE("the bars of the wave have the lengths that give 40 to 89 swings in 120 s") {
    const scenes::BallOnBar pendulum{.length = 0.0, .radius = 0.1, .gravity = 10.0};
    // Computed independently to six digits.
    CHECK(scenes::length_for_period(pendulum, 0.4, 120.0 / 40) == Approx(2.132577).margin(2e-5));
    CHECK(scenes::length_for_period(pendulum, 0.4, 120.0 / 65) == Approx(0.741214).margin(2e-5));
    CHECK(scenes::length_for_period(pendulum, 0.4, 120.0 / 89) == Approx(0.341645).margin(2e-5));
}

TEST_CASE("a chain keeps its links under substeps, better than without") {
    Settings settings = tests::awake_settings("default");
    settings.iterations = 500;
    settings.substeps = 1;
    Run one(simulate("chain", settings, {{"links", "10"}}));
    one.advance(3);
    settings.substeps = 8;
    Run eight(simulate("chain", settings, {{"links", "10"}}));
    eight.advance(3);
    CHECK(eight.measurements.max_length_error() < 0.2 * one.measurements.max_length_error());
}

TEST_CASE("a cube ten times as heavy stands on a light one, a thousand times is beyond 25 sweeps") {
    Run ten(simulate("heavy-on-light", tests::awake_settings("default"), {{"mass-ratio", "10"}}));
    ten.advance(10);
    CHECK(ten.measurements.outcome() == Outcome::rest);
    // A record of what a sweep cannot do and the direct solver can.
    Settings sweeping = tests::awake_settings("default");
    sweeping.solver = "pgs";
    Run thousand(simulate("heavy-on-light", sweeping, {{"mass-ratio", "1000"}}));
    thousand.advance(10);
    CHECK(thousand.measurements.fall_time());
}
