// Paper section 10.1 and 10.2: what the two stacks must do. Measured values are next to the bounds.
#include "demos/runs/measurements.h"
#include "engine/bodies/diagnostics.h"
#include "tests/catch.h"
#include "tests/scene_fixture.h"
#include "tests/settings.h"

#include <cmath>
#include <map>

using namespace pushfactor;
using namespace pushfactor::demos;
using tests::advance;
using tests::Run;
using tests::simulate;
using tests::solved_exactly;

namespace {

double height(const Simulation& simulation, std::size_t cube) {
    return simulation.scene().world.bodies[cube].position.y();
}

double upward_speed(const Simulation& simulation, std::size_t cube) {
    return velocity(simulation.scene().world.bodies[cube]).y();
}

// Sum of the contact forces of each pair in the last step, by the lower body.
std::map<int, double> pair_forces(const Simulation& simulation) {
    std::map<int, double> forces;
    const engine::World& world = simulation.scene().world;
    for (std::size_t j = 0; j < world.rows().size(); ++j) {
        const engine::ConstraintRow& row = world.rows()[j];
        if (row.label.kind != engine::RowKind::contact) continue;
        forces[row.body_a] += world.lambda()(static_cast<Eigen::Index>(j), world.lambda().cols() - 1);
    }
    return forces;
}

}  // namespace

TEST_CASE("the stack of the original method falls between 40 and 150 s") {
    // The paper saw 85 s. Measured 69.25 s from the exact start.
    Run run(simulate("stack", tests::awake_settings("paper")));
    run.advance(150);
    REQUIRE(run.measurements.fall_time());
    CHECK(*run.measurements.fall_time() > 40.0);
    CHECK(run.measurements.lean_time() < run.measurements.fall_time());
}

TEST_CASE("nine of nine jittered stacks stand for 600 s and do not creep", "[long]") {
    for (const char* seed : {"1", "2", "3", "4", "5", "6", "7", "8", "9"}) {
        INFO("seed " << seed);
        Run run(simulate("stack", tests::awake_settings("default"), {{"jitter", "0.01"}, {"seed", seed}}));
        run.advance(600);
        CHECK(run.measurements.outcome() == Outcome::rest);
        CHECK(!run.measurements.lean_time());
        CHECK(*run.measurements.drift_after_10_s() < 1e-6);      // measured 6e-9 .. 4.3e-8
        CHECK(run.measurements.max_speed_last_second() < 1e-8);  // measured 2.4e-9 .. 3.9e-9
    }
}

TEST_CASE("a jittered stack stands for an hour", "[long]") {
    Run run(simulate("stack", tests::awake_settings("default"), {{"jitter", "0.01"}}));
    run.advance(3600);
    CHECK(run.measurements.outcome() == Outcome::rest);
    CHECK(*run.measurements.drift_after_10_s() < 1e-6);
    CHECK(run.measurements.max_speed_last_second() < 1e-8);
}

TEST_CASE("a touching stack of ten stands for a minute") {
    Run run(simulate("stack", tests::awake_settings("default"), {{"count", "10"}, {"gap", "-0.0001"}}));
    run.advance(60);
    CHECK(run.measurements.outcome() == Outcome::rest);
    CHECK(!run.measurements.lean_time());
}

TEST_CASE("in a settled stack of n each pair carries the weight above it") {
    for (const int n : {3, 5}) {
        auto simulation = simulate("stack", tests::awake_settings("default"), {{"count", std::to_string(n)}});
        advance(simulation, 30);
        const auto forces = pair_forces(simulation);
        REQUIRE(forces.size() == static_cast<std::size_t>(n));
        for (const auto& [lower, force] : forces) {
            CHECK(force == Approx((n - lower) * 1.2 * 10.0).epsilon(1e-6));
        }
    }
}

TEST_CASE("the single-frame push sets the intersecting stack down") {
    Run run(simulate("intersecting-stack", tests::awake_settings("default")));
    run.advance(0.36);
    CHECK(run.simulation.sample().penetration.max < 0.02);  // reached at 0.333 s
    run.advance(5.0 - 0.36);
    CHECK(run.measurements.max_upward_speed() < 0.005);  // measured 1.13e-3 m/s
    CHECK(run.measurements.outcome() == Outcome::rest);
    for (std::size_t i = 1; i <= 5; ++i) {
        CHECK(height(run.simulation, i) == Approx(2.4 * static_cast<double>(i) - 1.2).margin(0.03));
    }
}

TEST_CASE("the original method throws the intersecting stack apart") {
    Run run(simulate("intersecting-stack", tests::awake_settings("paper")));
    run.advance(0.5);
    CHECK(run.simulation.sample().count.rows() == 0);  // nothing touches any more
    double below = 0.0;
    for (std::size_t i = 1; i <= 5; ++i) {
        CHECK(upward_speed(run.simulation, i) > 8.0);  // measured 9.0 .. 25.4 m/s
        CHECK(upward_speed(run.simulation, i) < 26.0);
        CHECK(height(run.simulation, i) - below > 2.4);
        below = height(run.simulation, i);
    }
    CHECK(run.measurements.outcome() == Outcome::fly);
}

TEST_CASE(
    "solved exactly, the persistent push gives cube i the speed beta (1.2 + 0.4 (i - 1)) / dt and then it flies") {
    for (const double beta : {0.2, 0.5}) {
        Settings settings = solved_exactly(tests::awake_settings("paper"));
        settings.contacts.beta = beta;
        auto simulation = simulate("intersecting-stack", settings);
        for (int n = 1; n <= 30; ++n) {
            simulation.advance();
            const double t = n / 60.0;
            for (std::size_t i = 1; i <= 5; ++i) {
                const double start = 60.0 * beta * (1.2 + 0.4 * (static_cast<double>(i) - 1.0));
                REQUIRE(upward_speed(simulation, i) == Approx(start - 10.0 * (t - 1.0 / 60.0)).epsilon(1e-6));
            }
        }
        if (beta == 0.2) CHECK(height(simulation, 5) == Approx(23.592).margin(1e-3));
    }
}

TEST_CASE("solved exactly, the single-frame push shrinks every overlap by 1 - beta a step at speed zero") {
    for (const double beta : {0.05, 0.2}) {
        Settings settings = solved_exactly(tests::awake_settings("default"));
        settings.contacts.beta = beta;
        settings.slop = 0.0;
        auto simulation = simulate("intersecting-stack", settings);
        for (int n = 1; n <= 30; ++n) {
            simulation.advance();
            const double left = std::pow(1.0 - beta, n);
            for (std::size_t i = 1; i <= 5; ++i) {
                const double cube = static_cast<double>(i);
                REQUIRE(height(simulation, i) ==
                        Approx(2.4 * cube - 1.2 - (1.2 + 0.4 * (cube - 1.0)) * left).margin(1e-6));
                REQUIRE(std::abs(upward_speed(simulation, i)) < 1e-6);
            }
        }
    }
}

TEST_CASE("a higher beta throws higher under the persistent push, and never under the single-frame push") {
    double last_peak = 0.0;
    for (const double beta : {0.05, 0.1, 0.2, 0.4}) {
        Settings settings = tests::awake_settings("paper");
        settings.contacts.beta = beta;
        Run original(simulate("intersecting-stack", settings));
        original.advance(1.0);
        CHECK(original.measurements.max_upward_speed() > last_peak);
        last_peak = original.measurements.max_upward_speed();

        settings.contacts.kind = engine::PushKind::single_frame;
        Run improved(simulate("intersecting-stack", settings));
        improved.advance(1.0);
        // The cold sweep errs, so it is not zero: below 0.3 m/s for every beta of paper section 8.1.
        CHECK(improved.measurements.max_upward_speed() < 0.3);
    }
}

TEST_CASE("two runs of a scene give one state hash, and the first step with another seed gives another") {
    const auto hash = [](const char* seed) {
        auto simulation = simulate("stack", tests::awake_settings("default"), {{"jitter", "0.01"}, {"seed", seed}});
        advance(simulation, 5);
        return engine::state_hash(simulation.scene().world.bodies);
    };
    CHECK(hash("1") == hash("1"));
    CHECK(hash("1") != hash("2"));
}

TEST_CASE("a settled step has one column, a step that corrects has two") {
    auto simulation = simulate("intersecting-stack", tests::awake_settings("default"));
    simulation.advance();
    CHECK(simulation.sample().count.columns == 2);
    advance(simulation, 10);
    CHECK(simulation.sample().count.columns == 1);
}

TEST_CASE("substeps divide the step: their number times the rate gives the same run") {
    Settings divided = tests::awake_settings("default");
    divided.substeps = 4;
    Settings fast = tests::awake_settings("default");
    fast.dt = Rational{1, 240};
    auto a = simulate("stack", divided);
    auto b = simulate("stack", fast);
    for (int i = 0; i < 120; ++i) {
        a.advance();
        for (int k = 0; k < 4; ++k) b.advance();
    }
    CHECK(engine::state_hash(a.scene().world.bodies) == engine::state_hash(b.scene().world.bodies));
}
