// The rules for the length of a step, against closed forms.
#include "engine/measures/step_length.h"

#include "engine/forces/gravity.h"
#include "engine/world.h"
#include "tests/catch.h"

using namespace pushfactor::engine;

namespace {

// A ball of 2 kg on a bar of 3 m from the origin, and the cached force in the bar [N].
DistanceConstraints bar(double force, Distance::Acts acts = Distance::Acts::both) {
    DistanceConstraints bars({{.body_a = 0, .body_b = 1, .length = 3.0, .acts = acts}}, {}, true);
    bars.set_forces({DistanceForce{{{force, force}}}});
    return bars;
}

std::vector<Body> ball_at(const Vector3& position) {
    return {static_body(Vector3::Zero()), ball_body(2.0, 0.1, position)};
}

}  // namespace

TEST_CASE(
    "a bar under tension asks for two radians of its sideways swing in a step, one under pressure for nothing") {
    const std::vector<Body> bodies = ball_at({0, -3, 0});
    // A pendulum that hangs: T = m g, omega^2 = g / l.
    CHECK(tension_rate(bar(-20.0), bodies) == Approx(2.0 * std::sqrt(10.0 / 3.0)).epsilon(1e-14));
    CHECK(tension_rate(bar(20.0), bodies) == 0.0);
    CHECK(tension_rate(bar(0.0), bodies) == 0.0);
}

TEST_CASE("between two bodies the tension rule has their reduced mass, and at an end off the centre its inertia") {
    std::vector<Body> bodies{ball_body(2.0, 0.1, {0, 0, 0}), ball_body(6.0, 0.1, {0, -3, 0})};
    const double reduced_mass = 1.5;
    CHECK(tension_rate(bar(-12.0), bodies) == Approx(2.0 * std::sqrt(12.0 / (reduced_mass * 3.0))).epsilon(1e-14));

    // A bar so long that it does not turn: the body swings about its end alone, omega^2 = T r / I.
    bodies = {static_body(Vector3::Zero()), ball_body(2.0, 0.5, {0, -1e9, 0})};
    DistanceConstraints far({{.body_a = 0, .body_b = 1, .point_b = {0, 0.25, 0}, .length = 1e9 - 0.25}}, {}, true);
    far.set_forces({DistanceForce{{{-20.0, -20.0}}}});
    const double inertia = 0.4 * 2.0 * 0.25;
    CHECK(tension_rate(far, bodies) == Approx(2.0 * std::sqrt(20.0 * 0.25 / inertia)).epsilon(1e-6));
}

TEST_CASE(
    "a slender bar on a joint swings with its moment across itself, and what a force has across it does nothing") {
    std::vector<Body> bodies{static_body(Vector3::Zero()), box_body(2.0, {1.0, 0.05, 0.05}, {0.5, 0, 0})};
    bodies[1].orientation = Quaternion(Eigen::AngleAxisd(1.0, Vector3::UnitY()));
    JointConstraints joints({{.body_a = 0, .body_b = 1, .point_b = {-0.5, 0, 0}}}, {}, true);
    const auto rate_of = [&](const Vector3& force) {
        const Vector3 own = bodies[1].orientation * force;
        JointForce rows{};
        for (std::size_t k = 0; k < 3; ++k) rows[k].last = own[static_cast<Eigen::Index>(k)];
        joints.set_forces({rows});
        return tension_rate(joints, bodies);
    };
    const double across = 2.0 * (1.0 + 0.05 * 0.05) / 12.0;
    const double swing = 2.0 * std::sqrt(20.0 * 0.5 / across);
    CHECK(rate_of({-20, 0, 0}) == Approx(swing).epsilon(1e-12));
    CHECK(rate_of({-20, 300, 0}) == Approx(swing).epsilon(1e-12));
    CHECK(rate_of({0, 300, 400}) < 1e-6 * swing);
}

TEST_CASE(
    "a hanging pendulum keeps its energy at the length that the tension rule allows and gains it at 4 times") {
    const auto highest_after = [](double share) {
        World world;
        world.bodies = ball_at({0.3, -std::sqrt(9.0 - 0.09), 0});
        world.forces.push_back(std::make_unique<Gravity>(Vector3(0, -10, 0)));
        world.constraints.push_back(
            std::make_unique<DistanceConstraints>(std::vector{Distance{.body_a = 0, .body_b = 1, .length = 3.0}},
                                                  Correction{PushKind::persistent, 1.0}, true));
        world.solver = solvers::make_solver("direct");
        world.termination = {100, 1e-12, 1e-12};
        const double dt = share / (2.0 * std::sqrt(10.0 / 3.0));
        double sideways = 0.0;
        for (int i = 0; i < 400; ++i) {
            world.step(dt);
            sideways = std::max(sideways, std::abs(world.bodies[1].position.x()));
        }
        return sideways;
    };
    CHECK(highest_after(1.0) < 0.33);  // measured 0.3154
    CHECK(highest_after(4.1) > 1.0);
}

TEST_CASE("a bar that turns asks for 0.034 radians in a step, whatever moves along it or with it") {
    std::vector<Body> bodies = ball_at({3, 0, 0});
    bodies[1].linear_momentum = 2.0 * Vector3(7, 6, 0);  // along and across
    CHECK(turning_rate(bar(0.0), bodies) == Approx((6.0 / 3.0) / 0.034).epsilon(1e-14));

    std::vector<Body> both{ball_body(1.0, 0.1, {0, 0, 0}), ball_body(1.0, 0.1, {3, 0, 0})};
    for (Body& body : both) body.linear_momentum = {4, 5, 6};
    CHECK(turning_rate(bar(0.0), both) == 0.0);
}

TEST_CASE(
    "a spin about the way to a ball joint counts as far as it makes the body nod, and all of a turn across it") {
    const auto rate_of = [](const Vector3& size, const Vector3& spin, bool hinge) {
        std::vector<Body> bodies{static_body(Vector3::Zero()), box_body(2.0, size, {0.5, 0, 0})};
        bodies[1].angular_momentum = spin.cwiseQuotient(bodies[1].inverse_inertia);
        Joint joint{.body_a = 0, .body_b = 1, .point_b = {-0.5, 0, 0}};
        if (hinge) joint.hinge = Hinge{};
        return turning_rate(JointConstraints({joint}, {}, true), bodies);
    };
    const Vector3 bar(1.0, 0.05, 0.05), disc(0.1, 1.0, 1.0);
    const double nods = 2.0 * 0.05 * 0.05 / (1.0 + 0.05 * 0.05);
    CHECK(rate_of(bar, {7, 0, 0}, false) == Approx(nods * 7.0 / 0.034).epsilon(1e-12));
    CHECK(rate_of(bar, {0, 7, 0}, false) == Approx(7.0 / 0.034).epsilon(1e-12));
    CHECK(rate_of(bar, {7, 0, 0}, true) == Approx(7.0 / 0.034).epsilon(1e-12));
    CHECK(rate_of(disc, {7, 0, 0}, false) == Approx(7.0 / 0.034).epsilon(1e-12));
}

TEST_CASE("a rope that carries nothing and a ball joint at both centres ask for nothing") {
    std::vector<Body> bodies = ball_at({1, 0, 0});
    bodies[1].linear_momentum = {0, 100, 0};
    CHECK(turning_rate(bar(0.0, Distance::Acts::pulls), bodies) == 0.0);
    CHECK(turning_rate(bar(-1.0, Distance::Acts::pulls), bodies) > 0.0);

    bodies = ball_at({0, 0, 0});
    bodies[1].linear_momentum = {0, 100, 0};
    CHECK(turning_rate(bar(-1.0), bodies) == 0.0);
    DistanceConstraints none({{.body_a = 0, .body_b = 1, .length = 0.0}}, {}, true);
    none.set_forces({DistanceForce{Lambda{-1.0, -1.0}}});
    CHECK(turning_rate(none, bodies) == 0.0);
    CHECK(tension_rate(none, bodies) == 0.0);
}
