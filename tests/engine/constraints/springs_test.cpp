// Springs: soft rows of every solver against closed forms.
#include "engine/bodies/diagnostics.h"
#include "engine/constraints/distance_constraints.h"
#include "engine/constraints/joint_constraints.h"
#include "engine/energy_account.h"
#include "engine/forces/gravity.h"
#include "engine/rattle.h"
#include "engine/step/rest.h"
#include "engine/world.h"
#include "tests/catch.h"
#include "tests/random.h"

#include <cmath>
#include <complex>
#include <numbers>

using namespace pushfactor::engine;
using Catch::Matchers::WithinAbs;
using pushfactor::tests::Random;

namespace {

constexpr double pi = std::numbers::pi;

// A ball of 2 kg on a spring of 3 m along x, that is `longer` at the start.
World ball_on(const Spring& spring, double longer, const char* solver = "direct") {
    World world;
    world.bodies = {static_body(Vector3::Zero()), ball_body(2.0, 0.5, {3.0 + longer, 0, 0})};
    world.constraints.push_back(std::make_unique<DistanceConstraints>(
        std::vector{Distance{.body_a = 0, .body_b = 1, .length = 3.0, .spring = spring}}, Correction{}, true));
    world.solver = solvers::make_solver(solver);
    world.termination = {.iterations = 25, .tolerance_high = 1e-12, .tolerance_low = 1e-12};
    return world;
}

// v' = (v - dt k/m x) / (1 + dt c/m + dt^2 k/m), x' = x + dt v': implicit Euler.
struct Oscillator {
    double mass, x, v = 0.0;
    void step(const Spring& spring, double dt) {
        v = (v - dt * spring.stiffness / mass * x) /
            (1.0 + dt * spring.damping / mass + dt * dt * spring.stiffness / mass);
        x += dt * v;
    }
};

// Two boxes and a ball between springs of all kinds, a bar and a ball joint.
World mixed(Random& random, const char* solver, int iterations) {
    World world;
    world.bodies = {static_body(Vector3::Zero()), box_body(1.0, {1, 0.5, 0.4}, {1, 0, 0}, random.rotation()),
                    box_body(3.0, {0.5, 0.5, 0.8}, {2.5, 0.3, 0}, random.rotation()),
                    ball_body(0.5, 0.3, {2, 1.5, 0.2})};
    for (std::size_t i = 1; i < 4; ++i) world.bodies[i].linear_momentum = random.vector(-1, 1);
    std::vector<Distance> distances;
    const auto add = [&](int a, int b, const std::optional<Spring>& spring) {
        distances.push_back({.body_a = a,
                             .body_b = b,
                             .point_a = random.vector(-0.4, 0.4),
                             .point_b = random.vector(-0.4, 0.4),
                             .length = random.in(0.5, 2.0),
                             .spring = spring});
    };
    add(0, 1, Spring{random.in(1, 1000), 0.0});
    add(1, 2, Spring{random.in(1, 1e6), random.in(0, 100)});
    add(0, 2, Spring{0.0, random.in(1, 100)});
    add(2, 3, Spring{random.in(1, 1000), random.in(0, 10)});
    distances.push_back({.body_a = 1, .body_b = 3, .length = 1.8});
    world.constraints.push_back(
        std::make_unique<DistanceConstraints>(distances, Correction{PushKind::persistent, 0.2}, true));
    world.forces.push_back(std::make_unique<Gravity>(Vector3(0, -10, 0)));
    world.solver = solvers::make_solver(solver);
    world.termination = {.iterations = iterations, .tolerance_high = 1e-12, .tolerance_low = 1e-12};
    return world;
}

}  // namespace

TEST_CASE("a ball on a spring moves as implicit Euler does, soft or stiff, damped or not, at any step") {
    for (const Spring& spring : {Spring{50, 0}, Spring{50, 3}, Spring{0, 5}, Spring{1e9, 0}, Spring{1e9, 1e7}}) {
        for (const double dt : {1.0 / 60.0, 1.0 / 600.0, 0.2}) {
            World world = ball_on(spring, 0.4);
            Oscillator exact{.mass = 2.0, .x = 0.4};
            for (int i = 0; i < 300; ++i) {
                world.step(dt);
                exact.step(spring, dt);
                REQUIRE_THAT(world.bodies[1].position.x() - 3.0, WithinAbs(exact.x, 1e-9));
                REQUIRE_THAT(velocity(world.bodies[1]).x(), WithinAbs(exact.v, 1e-9));
            }
        }
    }
}

TEST_CASE("a spring has the period and the decay of the damped oscillator, and those of its step exactly") {
    const double stiffness = 50.0, damping = 1.0, mass = 2.0;
    const double decay = damping / (2.0 * mass), frequency = std::sqrt(stiffness / mass - decay * decay);
    for (const double dt : {1.0 / 60.0, 1.0 / 6000.0}) {
        // The factor by which a step turns and shrinks the oscillation: the roots of its 2 x 2 matrix.
        const double d = 1.0 + dt * damping / mass + dt * dt * stiffness / mass;
        const double trace = 1.0 / d + 1.0 - dt * dt * stiffness / mass / d, determinant = 1.0 / d;
        const std::complex<double> root =
            0.5 * (trace + std::sqrt(std::complex<double>(trace * trace - 4.0 * determinant)));
        World world = ball_on({stiffness, damping}, 0.4);
        std::vector<double> crossings, peaks;
        double before = 0.4, two_before = 0.4;
        for (int i = 1; crossings.size() < 9; ++i) {
            world.step(dt);
            const double now = world.bodies[1].position.x() - 3.0;
            if (before > 0.0 && now <= 0.0) crossings.push_back((i - now / (now - before)) * dt);
            if (i > 1 && before > two_before && before >= now) peaks.push_back(before);
            two_before = before;
            before = now;
        }
        const double period = (crossings[8] - crossings[0]) / 8.0;
        CHECK_THAT(period / (2.0 * pi * dt / std::arg(root)), WithinAbs(1.0, 1e-3));
        const double shrinks = std::pow(std::abs(root), period / dt);
        CHECK_THAT(peaks[7] / peaks[0], WithinAbs(std::pow(shrinks, 7), 0.02 * std::pow(shrinks, 7)));
        if (dt > 1e-3) continue;
        CHECK_THAT(period * frequency / (2.0 * pi), WithinAbs(1.0, 1e-4));
        CHECK_THAT(peaks[7] / peaks[0], WithinAbs(std::exp(-decay * 7.0 * period), 0.02));
    }
}

TEST_CASE("a weight hangs lower by m g / k, and comes to rest there") {
    World world = ball_on({400.0, 20.0}, 0.0);
    world.bodies[1].position = {0, -3, 0};
    world.forces.push_back(std::make_unique<Gravity>(Vector3(0, -10, 0)));
    world.rest = std::make_unique<Rest>();
    int at_rest = 0;
    for (int i = 0; i < 1200; ++i) at_rest = world.step(1.0 / 60.0).at_rest;
    CHECK_THAT(world.bodies[1].position.y(), WithinAbs(-3.0 - 20.0 / 400.0, 1e-5));
    CHECK(at_rest == 1);
}

TEST_CASE("every solver finds the forces of springs among bars, and they are k x + c v at the end of the step") {
    for (const auto& [solver, iterations] :
         {std::pair{"direct", 100}, {"auto", 25}, {"pgs", 20000}, {"nncg", 2000}, {"dense", 20000}}) {
        Random random(11);
        for (int i = 0; i < 10; ++i) {
            World world = mixed(random, solver, iterations);
            const std::vector<Body> before = world.bodies;
            const double dt = 1.0 / 60.0;
            world.step(dt);
            const auto& source = dynamic_cast<const DistanceConstraints&>(*world.constraints[0]);
            int springs = 0;
            for (std::size_t j = 0; j < world.rows().size(); ++j) {
                const ConstraintRow& row = world.rows()[j];
                if (row.label.kind != RowKind::spring) continue;
                ++springs;
                // The axis is that of the start of the step, and so is the inertia.
                double rate = 0.0;
                for (const auto& [body, axis] :
                     {std::pair{row.body_a, row.jacobian.a}, {row.body_b, row.jacobian.b}}) {
                    const auto at = static_cast<std::size_t>(body);
                    Body turned = world.bodies[at];
                    turned.orientation = before[at].orientation;
                    rate += axis.dot(stacked(velocity(turned), angular_velocity(turned)));
                }
                const Spring& spring = *source.distances()[static_cast<std::size_t>(row.label.point)].spring;
                const double force = -spring.stiffness * (row.label.gap + dt * rate) - spring.damping * rate;
                INFO(solver << ", row " << j << ", " << spring.stiffness << " N/m");
                const double scale = 1.0 + spring.stiffness * dt + spring.damping;
                CHECK_THAT(world.lambda()(static_cast<Eigen::Index>(j), 0) - force, WithinAbs(0.0, 1e-8 * scale));
            }
            CHECK(springs == 4);
            CHECK(world.residual() < 1e-9);
        }
    }
}

TEST_CASE("springs and limits that act one way are solved exactly together") {
    // A bar on a hinge, pressed against its limit by a spring: the limit carries what the spring pushes.
    World world;
    world.bodies = {static_body(Vector3::Zero()), box_body(1.0, {1, 0.1, 0.1}, {0.5, 0, 0})};
    Joint joint{.body_a = 0, .body_b = 1, .point_b = {-0.5, 0, 0}};
    joint.hinge = Hinge{.limits = AngleLimits{0.0, 1.0}};
    auto joints = std::make_unique<JointConstraints>(std::vector{joint}, Correction{}, true);
    const auto* const forces = joints.get();
    world.constraints.push_back(std::move(joints));
    world.constraints.push_back(
        std::make_unique<DistanceConstraints>(std::vector{Distance{.body_a = 0,
                                                                   .body_b = 1,
                                                                   .point_a = {1, 2, 0},
                                                                   .point_b = {0.5, 0, 0},
                                                                   .length = 3.0,
                                                                   .spring = Spring{100.0, 1.0}}},
                                              Correction{}, true));
    world.solver = solvers::make_solver("direct");
    world.termination = {.iterations = 25, .tolerance_high = 1e-12, .tolerance_low = 1e-12};
    for (int i = 0; i < 60; ++i) world.step(1.0 / 60.0);
    CHECK(std::abs(angular_velocity(world.bodies[1]).z()) < 1e-9);
    // 100 N at 1 m, over the lever of the row.
    const double lever = world.rows()[5].jacobian.b.tail<3>().norm();
    CHECK_THAT(forces->forces()[0][5].last * lever, WithinAbs(100.0, 1e-6));
    CHECK(forces->forces()[0][6].last == 0.0);
}

TEST_CASE("what a spring holds is energy of the scene, and its step never adds any") {
    for (const Spring& spring : {Spring{50, 0}, Spring{5000, 0}, Spring{50, 3}}) {
        World world = ball_on(spring, 0.4);
        EnergyAccount account{Vector3::Zero()};
        account.open(world.bodies, 1.0 / 240.0, world.stored_energy());
        double gain = 0.0;
        const double held = world.stored_energy();
        CHECK_THAT(held, WithinAbs(0.5 * spring.stiffness * 0.16, 1e-12));
        for (int i = 0; i < 480; ++i) {
            account.begin(world.bodies);
            world.step(1.0 / 240.0);
            account.end(world, 1.0 / 240.0);
            REQUIRE(account.gain() <= gain + 1e-12);
            gain = account.gain();
        }
        CHECK(gain < -0.1 * held);
    }
}

TEST_CASE("RATTLE refuses springs") {
    World world = ball_on({50, 0}, 0.4);
    CHECK_THROWS(rattle(world, 0.01));
}
