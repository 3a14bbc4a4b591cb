// Errata of paper section 8: the printed version and the right one.
#include "engine/constraints/contact_constraints.h"
#include "engine/constraints/contact_row.h"
#include "engine/forces/gravity.h"
#include "engine/world.h"
#include "tests/catch.h"
#include "tests/engine/paper/literal.h"
#include "tests/engine/solvers/problems.h"

#include <cmath>

using namespace pushfactor;
using namespace pushfactor::engine;
using tests::Frozen;

namespace {

constexpr double dt = 0.1;

// The cube of Figure 5 above a floor, without gravity: at 3 m/s it is 0.28 m deep after the first step.
World falling_cube(const Correction& correction) {
    World world;
    world.bodies = {static_body(Vector3::Zero()), box_body(1.0, Vector3::Ones(), {0, 0.52, 0})};
    world.bodies[1].linear_momentum = {0, -3, 0};
    world.constraints.push_back(std::make_unique<ContactConstraints>(
        std::vector<collision::Collider>{{.body = 0, .shape = collision::Plane{}},
                                         {.body = 1, .shape = collision::Box{}}},
        ContactChoices{.correction = correction, .slop = 0.0, .detection = {}}));
    world.solver = solvers::make_solver("direct");
    world.termination = {.iterations = 25};
    return world;
}

struct Frames {
    double height[4];     // m, of the lower face at the end of frames 1 to 4
    double speed_at_end;  // m/s
};

Frames frames(const Correction& correction) {
    World world = falling_cube(correction);
    Frames seen{};
    for (double& height : seen.height) {
        world.step(dt);
        height = world.bodies[1].position.y() - 0.5;
    }
    seen.speed_at_end = velocity(world.bodies[1]).y();
    return seen;
}

// 25 sweeps of `lambda` [N] for these rows, and J^T lambda.
std::vector<Vector6> sweep(std::span<const Body> bodies, std::span<const ConstraintRow> rows, double step,
                           Columns& lambda) {
    const Frozen frozen(bodies, rows, step);
    solvers::make_solver("pgs")->solve(frozen.system, {.iterations = 25}, lambda);
    std::vector<Vector6> forces;
    constraint_forces(frozen.system, lambda, 0, forces);
    return forces;
}

// The largest speed [m/s] of the stack of section 10.2 in its first half second with beta 0.6, when the second
// solve of 8.1 starts from `share` times the forces of the first. Cubes move straight here and do not turn.
double fastest_of_intersecting_stack(double share) {
    const double step = 1.0 / 60.0;
    std::vector<Body> bodies{static_body(Vector3::Zero())};
    std::vector<collision::Collider> colliders{{.body = 0, .shape = collision::Plane{}}};
    for (int i = 0; i < 5; ++i) {
        bodies.push_back(box_body(1.2, Vector3::Constant(2.4), {0, 2.0 * i, 0}));
        bodies.back().force = {0, -12, 0};
        colliders.push_back({.body = i + 1, .shape = collision::Box{Vector3::Constant(1.2)}});
    }
    ContactConstraints stage(colliders, {.correction = {PushKind::persistent, 0.6}, .slop = 0.0, .detection = {}});
    stage.set_friction(tests::weight_friction());
    double fastest = 0.0;
    for (int n = 0; n < 30; ++n) {
        std::vector<ConstraintRow> rows = pushfactor::tests::rows_of(stage, {bodies, step});
        Columns lambda = Columns::Zero(static_cast<Eigen::Index>(rows.size()), 1);
        const std::vector<Vector6> moving = sweep(bodies, rows, step, lambda);
        for (ConstraintRow& row : rows) row.push = {};
        lambda *= share;
        const std::vector<Vector6> lasting = sweep(bodies, rows, step, lambda);
        for (std::size_t i = 1; i < bodies.size(); ++i) {
            const Motion motion = motion_of(bodies[i], step, moving[i]);
            bodies[i].position += step * motion.velocity;
            bodies[i].linear_momentum += step * (bodies[i].force + lasting[i].head<3>());
            fastest = std::max(fastest, velocity(bodies[i]).norm());
        }
    }
    return fastest;
}

}  // namespace

TEST_CASE(
    "8.1: k is the beta of 5.2.3: with 1 the cube of Figure 5 is up in a frame and flies on, with less later") {
    const Frames one = frames({PushKind::persistent, 1.0});
    CHECK(one.height[0] == Approx(-0.28));
    CHECK(one.height[1] == Approx(0.0).margin(1e-12));
    CHECK(one.height[3] > 0.5);
    CHECK(one.speed_at_end == Approx(2.8));  // beta d / dt

    const Frames half = frames({PushKind::persistent, 0.5});
    CHECK(half.height[1] == Approx(-0.14));
    CHECK(half.speed_at_end < one.speed_at_end);

    const Frames single = frames({PushKind::single_frame, 1.0});
    CHECK(single.height[1] == Approx(0.0).margin(1e-12));
    CHECK(single.height[3] == Approx(0.0).margin(1e-12));
    CHECK(single.speed_at_end == Approx(0.0).margin(1e-12));
}

TEST_CASE(
    "8.1: the constraint is met when f_cv turns the body as well, moving it alone leaves what the turn would do") {
    const std::vector<Body> bodies{static_body(Vector3::Zero()), box_body(1.0, {1.0, 0.4, 0.2}, {0, 0.2, 0})};
    std::vector<ConstraintRow> rows;
    write_contact_row(PairPoint({0, 1, bodies[0], bodies[1]}, {0.5, 0, 0}), Vector3::UnitY(), -0.01,
                      {PushKind::persistent, 1.0}, 0.0, dt, rows.emplace_back());
    const double push = rows[0].push.lasting;
    const tests::Literal moving = tests::step_with(bodies, rows, dt);  // f_cv
    rows[0].push = {};
    const tests::Literal lasting = tests::step_with(bodies, rows, dt);  // f_c0
    CHECK(lasting.after[1].norm() < 1e-14);

    const Vector6& axis = rows[0].jacobian.b;
    CHECK(axis.dot(moving.after[1]) == Approx(push));
    Vector6 literal = lasting.after[1];  // "we use f_cv to calculate the translation"
    literal.head<3>() = moving.after[1].head<3>();
    const double linear_share = bodies[1].inverse_mass / moving.frozen.system.diagonal[0];
    CHECK(axis.dot(literal) == Approx(linear_share * push));
    CHECK(linear_share < 0.5);
}

TEST_CASE(
    "8.1: started from the forces of the first, a second solve of 25 sweeps throws the intersecting stack up") {
    CHECK(fastest_of_intersecting_stack(0.0) < 1.0);
    CHECK(fastest_of_intersecting_stack(1.0) > 2.0);
}

TEST_CASE(
    "8.1: beta below 1 keeps the contacts of a resting cube until rounding, a margin or a slop keeps them with 1") {
    const auto steps_without = [](double beta, double slop, double margin) {
        World world;
        world.bodies = {static_body(Vector3::Zero()), box_body(1.0, Vector3::Ones(), {0, 0.45, 0})};
        world.forces.push_back(std::make_unique<Gravity>(Vector3(0, -10, 0)));
        world.constraints.push_back(std::make_unique<ContactConstraints>(
            std::vector<collision::Collider>{{.body = 0, .shape = collision::Plane{}},
                                             {.body = 1, .shape = collision::Box{}}},
            ContactChoices{
                .correction = {PushKind::single_frame, beta}, .slop = slop, .detection = {.margin = margin}}));
        world.solver = solvers::make_solver("direct");
        world.termination = {.iterations = 25};
        int count = 0;
        for (int n = 0; n < 60; ++n) count += world.step(1.0 / 60.0).rows() == 0 ? 1 : 0;
        return count;
    };
    CHECK(steps_without(0.2, 0.0, 0.0) == 0);  // 0.05 m shrink to 0.05 (1 - beta)^60
    CHECK(steps_without(0.9, 0.0, 0.0) > 0);
    CHECK(steps_without(1.0, 0.0, 0.0) > 20);
    CHECK(steps_without(1.0, 0.002, 0.0) == 0);
    CHECK(steps_without(1.0, 0.0, 0.01) == 0);
}

TEST_CASE("8.2.1: for bodies that separate the printed rebound is below zero and takes away from the push") {
    const PushFactor push{.correcting = 0.0, .lasting = 0.8};
    const Impact separating{.speed = 2.0, .restitution = 0.5, .dt = dt};
    const double printed = -separating.restitution * separating.speed;
    CHECK(push.lasting + printed < 0.0);  // deeper into each other
    CHECK(restitution_sum(push, separating).lasting == 0.8);
}
