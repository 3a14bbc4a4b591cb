// Errata of paper section 5: the printed version and the right one.
#include "engine/constraints/contact_row.h"
#include "engine/constraints/distance_constraints.h"
#include "engine/constraints/friction_row.h"
#include "tests/catch.h"
#include "tests/engine/paper/literal.h"
#include "tests/random.h"

#include <cmath>

using namespace pushfactor;
using namespace pushfactor::engine;
using tests::Literal;
using tests::Random;
using tests::row_along;
using tests::step_with;

namespace {

constexpr double dt = 1.0 / 60.0;
const Vector3 gravity(0, -10, 0);

// A ball `length` [m] away from a fixed point, without gravity.
std::vector<Body> ball_at(double length) {
    return {static_body(Vector3::Zero()), ball_body(2.0, 0.1, {length, 0, 0})};
}

// The remaining share of the length error after a step with a bar of this axis and push.
double error_left(double length, double error, const Vector3& axis, double push) {
    const Literal step = step_with(ball_at(length + error), std::vector{row_along(axis, push)}, dt);
    return ((step.bodies[1].position - step.bodies[0].position).norm() - length) / error;
}

Body resting_box(double mass) {
    Body body = box_body(mass, Vector3::Ones(), {0, 0.5, 0});
    body.force = mass * gravity;
    return body;
}

}  // namespace

TEST_CASE("5.2.3: the printed sign doubles the error of a bar in one step, the minus sign removes it") {
    for (const double error : {0.05, -0.05}) {
        const double printed = error / dt;  // beta 1
        CHECK(error_left(1.0, error, Vector3::UnitX(), printed) == Approx(2.0));
        CHECK(error_left(1.0, error, Vector3::UnitX(), -printed) == Approx(0.0).margin(1e-12));
    }
}

TEST_CASE("5.2.1: along p_ab itself a push in m/s corrects 1 / |p_ab| of the error, three ways correct it all") {
    for (const double length : {0.2, 1.0, 20.0}) {
        const double error = 0.05 * length;
        const double apart = length + error;
        const Vector3 p_ab(apart, 0, 0);
        const double push = -error / dt;
        CHECK(error_left(length, error, p_ab, push) == Approx(1.0 - 1.0 / apart));  // 5 m: a fifth; 0.2 m: diverges
        CHECK(error_left(length, error, p_ab.normalized(), push) == Approx(0.0).margin(1e-11));
        CHECK(error_left(length, error, p_ab, push * apart) == Approx(0.0).margin(1e-11));
        // -c / dt with c as section 5.2 has it leaves an error of second order.
        const double c = 0.5 * (apart * apart - length * length);
        CHECK(error_left(length, error, p_ab, -c / dt) == Approx(0.5 * error / apart));
    }
    CHECK(std::abs(error_left(0.2, 0.01, {0.21, 0, 0}, -0.01 / dt)) > 3.0);
}

TEST_CASE("5.2: the triple product keeps r_b with the velocity of b") {
    Random random(51);
    for (int i = 0; i < 100; ++i) {
        const Vector3 p = random.vector(-1, 1), omega_b = random.vector(-1, 1);
        const Vector3 r_a = random.vector(-1, 1), r_b = random.vector(-1, 1);
        CHECK(r_b.cross(p).dot(omega_b) == Approx(p.dot(omega_b.cross(r_b))).margin(1e-15));
        CHECK(std::abs(r_a.cross(p).dot(omega_b) - p.dot(omega_b.cross(r_b))) > 1e-6);
    }
}

TEST_CASE("5.2: half the difference of squares grows with the square of the scale, its push with the scale") {
    for (const double scale : {0.5, 2.0, 10.0}) {
        const auto printed = [](double s) { return 0.5 * (1.1 * s * 1.1 * s - s * s); };
        CHECK(printed(scale) == Approx(scale * scale * printed(1.0)));
        const auto row = [](double s) {
            std::vector<ConstraintRow> rows = pushfactor::tests::rows_of(
                DistanceConstraints({{.body_a = 0, .body_b = 1, .length = s}}, {PushKind::persistent, 0.2}, false),
                {ball_at(1.1 * s), dt});
            return rows.front();
        };
        CHECK(row(scale).label.gap == Approx(scale * row(1.0).label.gap));  // c = |p_ab| - l
        CHECK(row(scale).push.lasting == Approx(scale * row(1.0).push.lasting));
        CHECK(row(scale).jacobian.b.head<3>() == row(1.0).jacobian.b.head<3>());
    }
}

TEST_CASE("5.3: a normal from a to b parts the bodies by d, one from b to a presses them together by d") {
    const double depth = 0.05;
    const std::vector<Body> bodies{static_body(Vector3::Zero()), ball_body(1.0, 0.5, {0, 0.5 - depth, 0})};
    const auto depth_after = [&](const Vector3& normal) {
        std::vector<ConstraintRow> rows;
        write_contact_row(PairPoint({0, 1, bodies[0], bodies[1]}, Vector3::Zero()), normal, -depth,
                          {PushKind::persistent, 1.0}, 0.0, dt, rows.emplace_back());
        CHECK(rows[0].push.lasting == Approx(depth / dt));  // 5.3.1, where c = -d
        return 0.5 - step_with(bodies, rows, dt).bodies[1].position.y();
    };
    CHECK(depth_after(Vector3::UnitY()) == Approx(0.0).margin(1e-13));
    CHECK(depth_after(-Vector3::UnitY()) == Approx(2.0 * depth));
}

TEST_CASE("5.3: whether the block of a static body is zero or not makes no difference, on either side") {
    Random random(53);
    const Body wall = static_body({1, 2, 3}, random.rotation());
    Body box = box_body(1.5, {1.0, 0.4, 0.2}, Vector3::Zero(), random.rotation());
    box.force = {3, -10, 1};
    for (const bool static_a : {false, true}) {
        const std::vector<Body> bodies = static_a ? std::vector{wall, box} : std::vector{box, wall};
        std::vector<ConstraintRow> rows;
        const Vector3 point(0.4, 0.1, 0.1), n = Vector3(static_a ? 1 : -1, 2, static_a ? 2 : -2) / 3.0;
        write_contact_row(PairPoint({0, 1, bodies[0], bodies[1]}, point), n, -0.01, {PushKind::persistent, 0.2},
                          0.0, dt, rows.emplace_back());
        const Literal simplified = step_with(bodies, rows, dt);
        rows[0].jacobian.a = stacked(-n, -(point - bodies[0].position).cross(n));
        rows[0].jacobian.b = stacked(n, (point - bodies[1].position).cross(n));
        const Literal full = step_with(bodies, rows, dt);
        CHECK(full.lambda(0, 0) == Approx(simplified.lambda(0, 0)).epsilon(1e-14));
        CHECK((full.after[static_a ? 1 : 0] - simplified.after[static_a ? 1 : 0]).norm() < 1e-13);
    }
}

TEST_CASE("5.4: where g n is below zero the printed bounds cross and push a resting box, on a wall they are zero") {
    const double mu = 0.5, mass = 2.0;
    const std::vector<Body> bodies{static_body(Vector3::Zero()), resting_box(mass)};
    const Vector3 n = Vector3::UnitY();  // from a to b, so against gravity
    const auto speed_after = [&](const Bounds& bounds) {
        std::vector<ConstraintRow> rows{row_along(n, 0.0), row_along(Vector3::UnitX(), 0.0)};
        rows[0].bounds.c_min = 0.0;
        rows[1].bounds = bounds;
        const tests::Frozen frozen(bodies, rows, dt);
        Columns lambda = frozen.zero();
        solvers::make_solver("dense")->solve(frozen.system, {.iterations = 10}, lambda);  // 7.2: MIN, then MAX
        return dt * lambda(1, 0) / mass;
    };
    const double printed = mu * mass * gravity.dot(n);
    CHECK(printed == -10.0);
    CHECK(speed_after({.c_min = -printed, .c_max = printed}) == Approx(mu * 10.0 * dt));
    CHECK(speed_after({.c_min = printed, .c_max = -printed}) == 0.0);

    const BodyPair pair{0, 1, bodies[0], bodies[1]};
    const FrictionRule rule = weight_friction(gravity);
    CHECK(rule({.bodies = pair, .normal = n, .friction = mu, .points = 1}).limit == -printed);
    CHECK(rule({.bodies = pair, .normal = Vector3::UnitX(), .friction = mu, .points = 1}).limit == 0.0);
}

TEST_CASE("5.4: two tangents make a square of the cone: friction along its diagonal is sqrt(2) times as large") {
    const double mu = 0.3;
    for (const double angle : {0.31, 0.6}) {  // atan(mu) = 0.291, atan(sqrt(2) mu) = 0.401
        const Vector3 n(-std::sin(angle), std::cos(angle), 0);
        const Vector3 downhill(-std::cos(angle), -std::sin(angle), 0);
        const Vector3 across = n.cross(downhill);
        const std::vector<Body> bodies{static_body(Vector3::Zero()), resting_box(1.0)};
        const BodyPair pair{0, 1, bodies[0], bodies[1]};
        const double limit =
            weight_friction(gravity)({.bodies = pair, .normal = n, .friction = mu, .points = 1}).limit;
        const auto acceleration = [&](const Vector3& first) {
            std::vector<ConstraintRow> rows{row_along(n, 0.0), row_along(first, 0.0),
                                            row_along(n.cross(first), 0.0)};
            rows[0].bounds.c_min = 0.0;
            for (std::size_t i : {1u, 2u}) rows[i].bounds = {.c_min = -limit, .c_max = limit};
            return step_with(bodies, rows, dt).after[1].head<3>().dot(downhill) / dt;
        };
        const auto sliding = [&](double friction) {
            return std::max(0.0, 10.0 * (std::sin(angle) - friction * std::cos(angle)));
        };
        CHECK(acceleration(downhill) == Approx(sliding(mu)));
        CHECK(acceleration((downhill + across).normalized()) == Approx(sliding(std::sqrt(2.0) * mu)).margin(1e-12));
    }
}

TEST_CASE("5.4: under a stack of five the model has a fifth of the normal force, on top twice as much") {
    tests::Column column(5);
    for (Body& body : column.bodies) {
        if (body.is_static()) continue;
        body = resting_box(1.2);
    }
    const Literal step = step_with(column.bodies, column.rows, dt);
    const double model[] = {12, 24, 24, 24, 24};
    for (int pair = 0; pair < 5; ++pair) {
        const auto i = static_cast<std::size_t>(pair);
        const BodyPair bodies{pair, pair + 1, column.bodies[i], column.bodies[i + 1]};
        const FrictionSite site{.bodies = bodies, .normal = Vector3::UnitY(), .friction = 1.0, .points = 1};
        CHECK(weight_friction(gravity)(site).limit == Approx(model[i]));
        CHECK(step.lambda(pair, 0) == Approx(12.0 * (5 - pair)));
    }
}
