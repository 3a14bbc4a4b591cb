// RATTLE and its compositions against closed forms: order, reversibility, conserved quantities.
#include "engine/rattle.h"

#include "engine/base/invalid_input.h"
#include "engine/bodies/diagnostics.h"
#include "engine/constraints/distance_constraints.h"
#include "engine/forces/gravity.h"
#include "engine/forces/poke.h"
#include "tests/catch.h"

#include <cmath>
#include <numbers>

using namespace pushfactor::engine;

namespace {

const Vector3 gravity(0, -10, 0);

struct Method {
    StepMethod step;
    double order;
};
const Method methods[] = {{rattle, 2.0}, {rattle4, 4.0}, {rattle6, 6.0}};

// Bodies under gravity with bars between them; body 0 stands for the world. `cached` as in a run.
World held(std::vector<Body> bodies, std::vector<Distance> bars) {
    World world;
    world.bodies = std::move(bodies);
    world.bodies.insert(world.bodies.begin(), static_body(Vector3::Zero()));
    world.forces.push_back(std::make_unique<Gravity>(gravity));
    if (bars.empty()) return world;
    world.constraints.push_back(
        std::make_unique<DistanceConstraints>(std::move(bars), Correction{PushKind::persistent, 1.0}, true));
    world.solver = solvers::make_solver("pgs");
    world.termination = {.iterations = 10000, .tolerance_high = 1e-14, .tolerance_low = 1e-14};
    return world;
}

// A ball on a bar of 1 m that ends in its centre: a simple pendulum.
World simple_pendulum(double angle) {
    const Vector3 place(std::sin(angle), -std::cos(angle), 0);
    return held({ball_body(2.0, 0.1, place)}, {{.body_a = 0, .body_b = 1, .length = 1.0}});
}

// From rest at `angle` to the vertical [s]: a quarter of 2 pi sqrt(l / g) / agm(1, cos(angle / 2)).
double quarter_period(double angle) {
    double a = 1.0, b = std::cos(0.5 * angle);
    for (int i = 0; i < 8; ++i) std::tie(a, b) = std::pair(0.5 * (a + b), std::sqrt(a * b));
    return 0.5 * std::numbers::pi / std::sqrt(10.0) / a;
}

// A ball that hangs by its top, swings out of plane and spins about all axes.
World spinning_ball() {
    Body ball = ball_body(1.0, 0.2, {0.6, -1.0, 0});
    const Vector3 top(0, 0.2, 0);
    ball.linear_momentum = Vector3(0, 0, 1.5);
    ball.angular_momentum = 0.016 * Vector3(3, 20, -4);
    World world =
        held({ball}, {{.body_a = 0, .body_b = 1, .point_b = top, .length = (ball.position + top).norm()}});
    // Removes the velocity along the bar, as RATTLE requires at the start.
    const Vector3 n = (ball.position + top).normalized();
    const Vector3 at_top = velocity_at(ball, ball.position + top);
    world.bodies[1].linear_momentum -= at_top.dot(n) * n;
    return world;
}

// Three boxes of different moments, hinged at corners: rows that couple.
World hinged_boxes() {
    std::vector<Body> boxes;
    std::vector<Distance> bars;
    for (int i = 1; i <= 3; ++i) {
        boxes.push_back(box_body(1.0, {0.5, 0.2, 0.3}, {0.8 * i, 0, 0.1 * i}));
        bars.push_back(
            {.body_a = i - 1, .body_b = i, .point_a = {i > 1 ? 0.25 : 0.0, 0, 0}, .point_b = {-0.25, 0.1, 0.1}});
    }
    World world = held(boxes, {});
    for (Distance& bar : bars) {
        const auto [from, to] = span_of(bar, world.bodies);
        bar.length = (to - from).norm();
    }
    return held(std::move(boxes), std::move(bars));
}

void advance(World& world, StepMethod step, double seconds, int steps) {
    for (int i = 0; i < steps; ++i) step(world, seconds / steps);
}

double length_error(const World& world) {
    const auto& source = dynamic_cast<const DistanceConstraints&>(*world.constraints[0]);
    double largest = 0.0;
    for (const Distance& bar : source.distances()) {
        const auto [from, to] = span_of(bar, world.bodies);
        largest = std::max(largest, std::abs((to - from).norm() - bar.length));
    }
    return largest;
}

double energy(const World& world) {
    return kinetic_energy(world.bodies) + potential_energy(world.bodies, gravity);
}

// The error of the last body against `exact`: position and orientation.
double difference(const World& world, const World& exact) {
    const Body& body = world.bodies.back();
    const Body& other = exact.bodies.back();
    return (body.position - other.position).norm() + body.orientation.angularDistance(other.orientation);
}

// The observed order of the errors at steps of `seconds` / n and half of it, against `exact`.
double observed_order(World (*make)(), StepMethod step, double seconds, int n, const World& exact) {
    World coarse = make(), fine = make();
    advance(coarse, step, seconds, n);
    advance(fine, step, seconds, 2 * n);
    return std::log2(difference(coarse, exact) / difference(fine, exact));
}

}  // namespace

TEST_CASE("a ball on a bar to its centre passes the vertical after a quarter period, to the order of the method") {
    const double angle = 1.2;
    for (const auto& [step, order] : methods) {
        const auto error = [&, method = step](int n) {
            World world = simple_pendulum(angle);
            advance(world, method, quarter_period(angle), n);
            CHECK(length_error(world) < 1e-12);
            return std::abs(world.bodies[1].position.x());
        };
        CHECK(std::log2(error(16) / error(32)) == Approx(order).epsilon(0.05));
    }
    World world = simple_pendulum(angle);
    advance(world, rattle6, quarter_period(angle), 120);
    CHECK(std::abs(world.bodies[1].position.x()) < 1e-11);
}

TEST_CASE("balls that spin on a bar to their top and boxes with coupled rows show the same orders") {
    for (const auto make : {spinning_ball, hinged_boxes}) {
        World exact = make();
        advance(exact, rattle6, 0.5, 800);
        for (const auto& [step, order] : methods) {
            CHECK(observed_order(make, step, 0.5, 80, exact) == Approx(order).epsilon(0.05));
        }
    }
}

TEST_CASE("a step forwards and a step back is where it began, and time too") {
    for (const auto make : {spinning_ball, hinged_boxes}) {
        for (const auto& [step, order] : methods) {
            const World start = make();
            World world = make();
            advance(world, step, 0.5, 60);
            INFO("order " << order << ", " << world.bodies.size() << " bodies");
            CHECK(difference(world, start) > 0.1);
            CHECK(length_error(world) < 1e-12);
            advance(world, step, -0.5, 60);
            CHECK(difference(world, start) < 1e-10);
            CHECK((world.bodies[1].linear_momentum - start.bodies[1].linear_momentum).norm() < 1e-10);
            CHECK(world.time() == Approx(0.0).margin(1e-14));
        }
    }
}

TEST_CASE("the energy of a pendulum swings within dt^2 and does not drift, the bar keeps its length") {
    World world = simple_pendulum(0.8);
    const double start = energy(world);
    const auto largest_error = [&](int steps) {
        double largest = 0.0;
        for (int n = 0; n < steps; ++n) {
            rattle(world, 1.0 / 60);
            largest = std::max(largest, std::abs(energy(world) - start));
        }
        return largest;
    };
    const double first = largest_error(600);
    largest_error(30000);
    CHECK(largest_error(600) == Approx(first).epsilon(0.02));
    CHECK(first < 0.01);
    CHECK(length_error(world) < 1e-12);
}

TEST_CASE("the angular momentum about the vertical through the hook stays, whatever the ball does") {
    for (const auto& [step, order] : methods) {
        World world = spinning_ball();
        const double start = angular_momentum(world.bodies).y();
        advance(world, step, 5.0, 300);
        CHECK(angular_momentum(world.bodies).y() == Approx(start).epsilon(1e-11));
        CHECK(length_error(world) < 1e-12);
    }
}

TEST_CASE("lambda is the force of the bar at the end of the step") {
    World world = simple_pendulum(0.8);
    advance(world, rattle4, 0.7, 400);
    const Body& ball = world.bodies[1];
    const double tension = 2.0 * (velocity(ball).squaredNorm() - 10.0 * ball.position.y());
    CHECK(-world.lambda()(0, 0) == Approx(tension).epsilon(2e-3));
    CHECK(world.rows().size() == 1);
    CHECK(world.system().row_count() == 1);
}

TEST_CASE("RK4 adds nothing: a free body flies the parabola to rounding and tumbles to the order of the method") {
    const auto thrown = [] {
        Body box = box_body(1.5, {1.0, 0.4, 0.2}, {1, 2, 3});
        box.linear_momentum = {3, 4, 5};
        box.angular_momentum = world_inverse_inertia(box).inverse() * Vector3(0.3, 5.0, 0.2);
        World world = held({box}, {});
        // From before the start: the first step of a composition looks back beyond it.
        world.forces.push_back(std::make_unique<PokeForce>(Poke{.body = 1, .force = {1, 0, 2}, .from = -1.0}));
        return world;
    };
    World exact = thrown();
    advance(exact, rattle6, 1.0, 2000);
    for (const auto& [step, order] : methods) {
        World world = thrown();
        advance(world, step, 1.0, 60);
        const Vector3 acceleration = gravity + Vector3(1, 0, 2) / 1.5;
        const Vector3 place = Vector3(1, 2, 3) + Vector3(3, 4, 5) / 1.5 + 0.5 * acceleration;
        CHECK((world.bodies[1].position - place).norm() < 1e-12);
        CHECK(observed_order(thrown, step, 1.0, 50, exact) == Approx(order).epsilon(0.05));
    }
}

TEST_CASE("a force that changes with time is seen at the times of the moves") {
    struct Shaker : ForceSource {
        void add_forces(const ForcedBodies& bodies, double time, double) override {
            bodies[0].force.x() += std::cos(3.0 * time);
        }
    };
    for (const auto& [step, order] : methods) {
        const auto error = [method = step](int n) {
            World world;
            world.bodies.push_back(ball_body(1.0, 0.1, Vector3::Zero()));
            world.forces.push_back(std::make_unique<Shaker>());
            advance(world, method, 2.0, n);
            return std::abs(world.bodies[0].position.x() - (1.0 - std::cos(6.0)) / 9.0);
        };
        CHECK(std::log2(error(20) / error(40)) == Approx(order).epsilon(0.05));
    }
}

TEST_CASE("a step counts the work of all its solves") {
    World one = simple_pendulum(0.8), five = simple_pendulum(0.8);
    const StepCount count = rattle(one, 1.0 / 60);
    const StepCount composed = rattle4(five, 1.0 / 60);
    CHECK(count.rows(RowKind::distance) == 1);
    CHECK(count.columns == 1);
    CHECK(count.sweeps >= 2);
    CHECK(composed.rows() == 1);
    CHECK(composed.sweeps > count.sweeps);
    CHECK(composed.multiply_adds > count.multiply_adds);
}

TEST_CASE("rows with bounds are refused") {
    const Distance ropes[] = {{.body_a = 0, .body_b = 1, .acts = Distance::Acts::pulls},
                              {.body_a = 0, .body_b = 1, .acts = Distance::Acts::pushes},
                              {.body_a = 0, .body_b = 1, .max_force = 5.0}};
    for (const Distance& rope : ropes) {
        World world = held({ball_body(1.0, 0.1, {0, -1, 0})}, {rope});
        CHECK_THROWS_AS(rattle(world, 1.0 / 60), InvalidInput);
        CHECK(world.time() == 0.0);
    }
}
