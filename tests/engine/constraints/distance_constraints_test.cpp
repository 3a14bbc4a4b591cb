// The distance constraint, paper section 5.2, against closed forms and finite differences.
#include "engine/constraints/distance_constraints.h"

#include "engine/bodies/diagnostics.h"
#include "engine/bodies/integrator.h"
#include "engine/forces/gravity.h"
#include "engine/world.h"
#include "tests/catch.h"
#include "tests/engine/rows.h"
#include "tests/random.h"

#include <cmath>

using namespace pushfactor::engine;
using pushfactor::tests::Random;

namespace {

constexpr double dt = 1.0 / 60.0;

// A ball of 2 kg below the origin, held by `distance` (its bodies are filled in), under gravity 10.
World hanging(Distance distance, double start, const Correction& correction, double solve_to = 1e-13) {
    World world;
    world.bodies = {static_body(Vector3::Zero()), ball_body(2.0, 0.1, {0, -start, 0})};
    world.forces.push_back(std::make_unique<Gravity>(Vector3(0, -10, 0)));
    distance.body_a = 0;
    distance.body_b = 1;
    world.constraints.push_back(std::make_unique<DistanceConstraints>(std::vector{distance}, correction, true));
    world.solver = solvers::make_solver("pgs");
    world.termination = {.iterations = 100, .tolerance_high = solve_to, .tolerance_low = solve_to};
    return world;
}

double length_of(const World& world) {
    return world.bodies[1].position.norm();
}

const Correction persistent{PushKind::persistent, 0.2};

}  // namespace

TEST_CASE("j_c v_ab is the rate of the distance, by finite differences at random poses") {
    Random random(14);
    for (int i = 0; i < 200; ++i) {
        std::vector<Body> bodies;
        for (int k = 0; k < 2; ++k) {
            Body body = box_body(1.0, random.vector(0.5, 2), random.vector(-2, 2), random.rotation());
            body.linear_momentum = random.vector(-1, 1);
            body.angular_momentum = random.vector(-0.2, 0.2);
            bodies.push_back(body);
        }
        Distance distance{
            .body_a = 0, .body_b = 1, .point_a = random.vector(-1, 1), .point_b = random.vector(-1, 1)};
        DistanceConstraints source({distance}, persistent, false);
        std::vector<ConstraintRow> rows = pushfactor::tests::rows_of(source, {bodies, dt});
        double rate = 0.0;
        for (int k = 0; k < 2; ++k) {
            const Body& body = bodies[static_cast<std::size_t>(k)];
            Vector6 v;
            v << velocity(body), angular_velocity(body);
            rate += (k == 0 ? rows[0].jacobian.a : rows[0].jacobian.b).dot(v);
        }
        const auto distance_after = [&](double time) {
            std::vector<Body> moved = bodies;
            for (Body& body : moved) {
                const Vector3 turn = angular_velocity(body) * time;
                body.position += velocity(body) * time;
                body.orientation = Quaternion(Eigen::AngleAxisd(turn.norm(), turn.normalized())) * body.orientation;
            }
            const auto [from, to] = span_of(distance, moved);
            return (to - from).norm();
        };
        const double h = 1e-6;
        REQUIRE(rate == Approx((distance_after(h) - distance_after(-h)) / (2 * h)).margin(1e-7));
    }
}

TEST_CASE("a bar that is too long shortens by beta of its error a step, and by its whole error with beta 1") {
    // The sign of 5.2.3 as printed would lengthen it.
    for (const double beta : {0.2, 1.0}) {
        World world = hanging({.length = 1.0}, 1.05, {PushKind::single_frame, beta});
        for (int n = 1; n <= 20; ++n) {
            world.step(dt);
            REQUIRE(length_of(world) - 1.0 == Approx(0.05 * std::pow(1.0 - beta, n)).margin(1e-12));
        }
    }
}

TEST_CASE("the force of a hanging bar is the weight, whatever its length") {
    for (const double length : {0.2, 1.0, 20.0}) {
        World world = hanging({.length = length}, length, persistent);
        for (int n = 0; n < 60; ++n) world.step(dt);
        CHECK(world.lambda()(0, 0) == Approx(-20.0));  // below zero pulls
        CHECK(length_of(world) == Approx(length).epsilon(1e-12));
    }
}

TEST_CASE("a rope holds a ball that falls into it and lets it rise") {
    const Distance rope{.length = 1.0, .acts = Distance::Acts::pulls};
    World world = hanging(rope, 0.5, persistent);
    double longest = 0.0;
    for (int n = 0; n < 240; ++n) {
        world.step(dt);
        longest = std::max(longest, length_of(world));
        CHECK(world.lambda()(0, 0) <= 0.0);
    }
    CHECK(longest == Approx(1.0).epsilon(1e-9));  // it tightens within the step, so it never overshoots
    world.bodies[1].linear_momentum = {0, 10, 0};
    world.step(dt);
    CHECK(length_of(world) < 0.95);
    CHECK(world.lambda()(0, 0) == 0.0);
}

TEST_CASE("a strut carries and lets go upwards, a bar holds both ways") {
    // Turned around: the ball stands on a strut above the origin.
    for (const auto acts : {Distance::Acts::pushes, Distance::Acts::both}) {
        World world = hanging({.length = 1.0, .acts = acts}, -1.0, persistent);
        for (int n = 0; n < 30; ++n) world.step(dt);
        CHECK(world.lambda()(0, 0) == Approx(20.0));
        world.bodies[1].linear_momentum = {0, 4, 0};
        world.step(dt);
        const bool left = world.bodies[1].position.y() > 1.01;
        CHECK(left == (acts == Distance::Acts::pushes));
    }
}

TEST_CASE("a bar with a force limit yields with what is left of the weight") {
    World world = hanging({.length = 1.0, .max_force = 15.0}, 1.0, {PushKind::none, 0.0});
    for (int n = 0; n < 60; ++n) world.step(dt);
    CHECK(world.lambda()(0, 0) == Approx(-15.0));
    CHECK(velocity(world.bodies[1]).y() == Approx(-2.5));  // (20 - 15) N on 2 kg for 1 s
}

TEST_CASE("points that coincide have a direction: no number becomes infinite") {
    World world = hanging({.length = 1.0}, 0.0, persistent);
    for (int n = 0; n < 60; ++n) world.step(dt);
    CHECK(!find_non_finite(world.bodies));
    CHECK(length_of(world) == Approx(1.0).margin(1e-3));
}

TEST_CASE("on a swing the persistent push with beta 1 keeps the energy that the single-frame push eats") {
    const auto energy_left = [](const Correction& correction) {
        World world = hanging({.length = 1.0}, 1.0, correction);
        world.bodies[1].position = Vector3(std::sin(0.8), -std::cos(0.8), 0);
        const Vector3 gravity(0, -10, 0);
        const double deepest = -20.0;
        const double start = potential_energy(world.bodies, gravity) - deepest;
        for (int n = 0; n < 3600; ++n) world.step(dt);
        return (kinetic_energy(world.bodies) + potential_energy(world.bodies, gravity) - deepest) / start;
    };
    const double keeps = energy_left({PushKind::persistent, 1.0});
    const double baumgarte = energy_left({PushKind::persistent, 0.2});
    const double eats = energy_left({PushKind::single_frame, 1.0});
    CHECK(keeps > 0.95);
    CHECK(energy_left({PushKind::curve, 1.0}) == keeps);
    CHECK(keeps > baumgarte);
    CHECK(baumgarte > eats + 0.2);
    CHECK(eats < 0.5);
}

TEST_CASE("of a bar's error what its turning leaves becomes momentum, everything else moves its bodies alone") {
    Random random(15);
    int turning[2] = {0, 0};
    for (int i = 0; i < 100; ++i) {
        std::vector<Body> bodies;
        for (int k = 0; k < 2; ++k) {
            bodies.push_back(box_body(1.0, random.vector(0.5, 2), random.vector(-2, 2), random.rotation()));
            bodies.back().linear_momentum = random.vector(-5, 5);
            bodies.back().angular_momentum = random.vector(-1, 1);
        }
        Distance distance{
            .body_a = 0, .body_b = 1, .point_a = random.vector(-1, 1), .point_b = random.vector(-1, 1)};
        // Its length while nothing acts on the bodies, and the second derivative by differences.
        const auto length_at = [&](double time) {
            const auto point = [&](const Body& body, const Vector3& own) -> Vector3 {
                Quaternion turned = body.orientation;
                for (int n = 0; n < 100; ++n) {
                    Body now = body;
                    now.orientation = turned;
                    turned = rotate_splitting(now, body.angular_momentum, time / 100);
                }
                return body.position + time * velocity(body) + turned * own;
            };
            return (point(bodies[1], distance.point_b) - point(bodies[0], distance.point_a)).norm();
        };
        const double h = 1e-3, curve = (length_at(h) - 2.0 * length_at(0) + length_at(-h)) / (h * h);
        const double speed = (length_at(h) - length_at(-h)) / (2.0 * h), along = -0.5 * dt * curve;
        for (const double share : {0.0, 0.6, 1.0, 1.9, 2.1, 5.0, -1.0}) {
            const double error = share * 0.5 * dt * dt * curve;
            distance.length = length_at(0) - error;
            DistanceConstraints source({distance}, {PushKind::curve, 1.0}, false);
            const ConstraintRow row = pushfactor::tests::rows_of(source, {bodies, dt})[0];
            INFO("bodies " << i << ", share " << share << ", speed " << speed << ", along " << along);
            CHECK(row.push.lasting + row.push.correcting == Approx(-error / dt).margin(1e-9));
            if (std::abs(curve) < 3.0) continue;  // else smaller than what is seen
            // What the push, the curve and the speed have in common stays; all of it where the rest is less.
            const double whole = -error / dt;
            const bool agree = whole * along > 0.0 && -speed * along > 0.0;
            const double least = std::min({std::abs(whole), std::abs(along), std::abs(speed)});
            const double common = agree ? std::copysign(least, whole) : 0.0;
            if (std::abs(std::abs(whole - common) - std::abs(common)) < 1e-3) continue;  // either
            ++turning[agree ? 1 : 0];
            const bool stays = std::abs(whole - common) < std::abs(common);
            CHECK(row.push.lasting == Approx(stays ? whole : common).epsilon(0.01).margin(1e-6));
        }
    }
    CHECK(turning[0] > 100);
    CHECK(turning[1] > 100);
}

TEST_CASE("half a kick back at the start makes a swing of second order") {
    const auto error = [](double step, bool kick) {
        World world = hanging({.length = 1.0}, 1.0, {PushKind::persistent, 1.0});
        world.bodies[1].position = Vector3(std::sin(0.02), -std::cos(0.02), 0);
        if (kick) world.kick_back_half(step);
        for (int n = 0; n < std::lround(1.0 / step); ++n) world.step(step);
        // A small swing about the centre is a pendulum of length 1: w^2 = 10, with 1/16 theta0^2 of the period.
        const double w = std::sqrt(10.0) / (1.0 + 0.02 * 0.02 / 16.0);
        return std::abs(std::asin(world.bodies[1].position.x()) - 0.02 * std::cos(w));
    };
    CHECK(error(1.0 / 60, true) / error(1.0 / 120, true) == Approx(4.0).margin(0.3));
    CHECK(error(1.0 / 60, false) / error(1.0 / 120, false) == Approx(2.0).margin(0.2));
    CHECK(error(1.0 / 60, true) < 0.1 * error(1.0 / 60, false));
}
