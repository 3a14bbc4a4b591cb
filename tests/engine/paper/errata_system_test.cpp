// Errata of paper sections 6, 7, 9, 10 and 12.3: the printed version and the right one.
#include "engine/constraints/contact_row.h"
#include "tests/catch.h"
#include "tests/dense_algebra.h"
#include "tests/engine/paper/literal.h"
#include "tests/engine/random_rows.h"
#include "tests/engine/solvers/problems.h"

#include <algorithm>
#include <cmath>

using namespace pushfactor;
using namespace pushfactor::engine;
using tests::Frozen;
using tests::Literal;
using tests::pseudo_inverse;
using tests::row_along;
using tests::step_with;

namespace {

constexpr double dt = 1.0 / 60.0;

// J as 6.1.2 means it: one line per row, six columns per body.
MatrixX jacobian_of(const Frozen& frozen) {
    const auto bodies = static_cast<Eigen::Index>(frozen.system.inverse_mass.size());
    MatrixX jacobian = MatrixX::Zero(frozen.system.row_count(), 6 * bodies);
    for (Eigen::Index j = 0; j < jacobian.rows(); ++j) {
        const ConstraintRow& row = frozen.rows[static_cast<std::size_t>(j)];
        jacobian.block<1, 6>(j, 6 * row.body_a) = row.jacobian.a.transpose();
        jacobian.block<1, 6>(j, 6 * row.body_b) = row.jacobian.b.transpose();
    }
    return jacobian;
}

// The pseudocode of 7.2 as it is printed, A[i,j] with its column first.
VectorX solve_as_printed(const MatrixX& A, const VectorX& b, const VectorX& c_min, const VectorX& c_max,
                         int iterations) {
    VectorX lambda = VectorX::Zero(b.size());
    for (int k = 0; k < iterations; ++k) {
        for (Eigen::Index j = 0; j < A.rows(); ++j) {
            lambda[j] = b[j];
            for (Eigen::Index i = 0; i < A.cols(); ++i) {
                if (i != j) lambda[j] -= A(j, i) * lambda[i];
            }
            lambda[j] /= A(j, j);
            lambda[j] = std::min(lambda[j], c_max[j]);
            lambda[j] = std::max(lambda[j], c_min[j]);
        }
    }
    return lambda;
}

VectorX solve_as_printed(const Frozen& frozen, int iterations) {
    VectorX c_min(frozen.system.row_count()), c_max(frozen.system.row_count());
    for (Eigen::Index j = 0; j < c_min.size(); ++j) {
        c_min[j] = frozen.rows[static_cast<std::size_t>(j)].bounds.c_min;
        c_max[j] = frozen.rows[static_cast<std::size_t>(j)].bounds.c_max;
    }
    return solve_as_printed(tests::dense_matrix(frozen.system), frozen.system.b.col(0), c_min, c_max, iterations);
}

// A ball of 2 kg that flies at `velocity` past a fixed point.
std::vector<Body> flying(const Vector3& velocity) {
    std::vector<Body> bodies{static_body(Vector3::Zero()), ball_body(2.0, 0.1, {1, 0, 0})};
    bodies[1].linear_momentum = 2.0 * velocity;
    return bodies;
}

tests::Problem stack_of_five() {
    return tests::tower_problem("stack", 5, 0.0, tests::weight_friction(), tests::persistent);
}

}  // namespace

TEST_CASE("6.1.2: J has a line for each row and six columns for each body, nothing else multiplies with v") {
    const Frozen frozen = tests::chain_problem(3).frozen();
    const MatrixX J = jacobian_of(frozen);
    const Eigen::Index n = 4, c = 3;
    REQUIRE(J.rows() == c);
    REQUIRE(J.cols() == 6 * n);
    CHECK(frozen.rows[0].jacobian.a.size() == 6);  // elements 1 to 6, and 7 to 12; 0 to 6 would be seven
    CHECK(frozen.rows[0].jacobian.a.size() + frozen.rows[0].jacobian.b.size() == 12);

    VectorX v(6 * n);  // 6.1.1
    for (Eigen::Index i = 0; i < v.size(); ++i) v[i] = std::sin(static_cast<double>(i));
    const VectorX Jv = J * v;
    for (Eigen::Index j = 0; j < c; ++j) {
        const ConstraintRow& row = frozen.rows[static_cast<std::size_t>(j)];
        CHECK(Jv[j] == Approx(row.jacobian.a.dot(v.segment<6>(6 * row.body_a)) +
                              row.jacobian.b.dot(v.segment<6>(6 * row.body_b))));
    }
    // A leading line, and twelve columns per body, give a number of columns other than v's number of lines.
    CHECK(J.transpose().cols() != v.size());
    CHECK(12 * n != v.size());
}

TEST_CASE("6.1.3: M^-1 makes velocities of momenta, of velocities it makes another quantity") {
    Body body = box_body(3.0, {1.0, 0.4, 0.2}, {1, 0, 0});
    body.linear_momentum = {3, -6, 1};
    body.angular_momentum = {0.2, -0.1, 0.3};
    const Frozen frozen(std::vector{static_body(Vector3::Zero()), body},
                        std::vector{row_along(Vector3::UnitX(), 0.0)}, dt);
    const InverseMass& inverse_mass = frozen.system.inverse_mass[1];
    const Vector6 v = stacked(velocity(body), angular_velocity(body));
    CHECK((accelerate(inverse_mass, stacked(body.linear_momentum, body.angular_momentum)) - v).norm() < 1e-14);
    CHECK((accelerate(inverse_mass, v) - v).norm() > 1.0);
}

TEST_CASE("6.2.1: constraint forces work at clamped rows and at rows with a push, and at no others") {
    const Vector3 x = Vector3::UnitX();
    const auto with = [](ConstraintRow row, double c_min, double c_max) {
        row.bounds = {.c_min = c_min, .c_max = c_max};
        return std::vector{row};
    };
    const std::vector<Body> approaching = flying({-3, 1, 0});
    const Literal bar = step_with(approaching, std::vector{row_along(x, 0.0)}, dt);
    CHECK(bar.speed_along(0) == Approx(0.0).margin(1e-14));
    CHECK(bar.power() == Approx(0.0).margin(1e-11));

    const Literal separating =
        step_with(flying({3, 1, 0}), with(row_along(x, 0.0), 0.0, std::numeric_limits<double>::infinity()), dt);
    CHECK(separating.lambda(0, 0) == 0.0);
    CHECK(separating.speed_along(0) == Approx(3.0));  // J v2 is not zero

    const Literal braked = step_with(approaching, with(row_along(x, 0.0), -5.0, 5.0), dt);  // as friction is
    CHECK(braked.lambda(0, 0) == 5.0);
    CHECK(braked.power() == Approx(5.0 * (-3.0 + dt * 5.0 / 2.0)));

    const Literal pushed = step_with(approaching, std::vector{row_along(x, 0.5)}, dt);
    CHECK(pushed.power() == Approx(pushed.lambda(0, 0) * 0.5));
}

TEST_CASE("6.2.9: a stack of five has 60 rows of rank 30, so many lambdas and one J^T lambda") {
    const tests::Problem stack = stack_of_five();
    const Frozen frozen = stack.frozen();
    const MatrixX A = tests::dense_matrix(frozen.system);
    REQUIRE(A.rows() == 60);
    Eigen::FullPivLU<MatrixX> factors(A);
    factors.setThreshold(1e-12);
    CHECK(factors.rank() == 30);

    const MatrixX kernel = factors.kernel();
    REQUIRE(kernel.cols() == 30);
    const MatrixX J = jacobian_of(frozen);
    for (Eigen::Index k = 0; k < kernel.cols(); ++k) {
        const VectorX other = kernel.col(k).normalized();  // may be added to any lambda of the equation
        CHECK((A * other).norm() < 1e-12);
        CHECK((J.transpose() * other).norm() < 1e-12);
    }
}

TEST_CASE("6.2.9: within bounds A lambda - b is not zero but points out of them") {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Frozen frozen = tests::random_rows(seed, 5, 8, 0.5);
        Columns lambda = frozen.zero();
        solvers::make_solver("direct")->solve(frozen.system, {.iterations = 1000}, lambda);
        const VectorX w = tests::dense_matrix(frozen.system) * lambda.col(0) - frozen.system.b.col(0);
        for (Eigen::Index j = 0; j < w.size(); ++j) {
            const Bounds& bounds = frozen.rows[static_cast<std::size_t>(j)].bounds;
            if (lambda(j, 0) <= bounds.c_min) {
                CHECK(w[j] > -1e-8);
            } else if (lambda(j, 0) >= bounds.c_max) {
                CHECK(w[j] < 1e-8);
            } else {
                CHECK(std::abs(w[j]) < 1e-8);
            }
        }
    }
    // The printed equation would pull at a body that flies away.
    const Frozen leaving(flying({3, 0, 0}), std::vector{row_along(Vector3::UnitX(), 0.0)}, dt);
    CHECK(leaving.system.b(0, 0) / leaving.system.diagonal[0] == Approx(-3.0 * 2.0 / dt));
}

TEST_CASE(
    "6.2.4: J v2 is the push with the inertia of the step's start, the next step begins with another velocity") {
    std::vector<Body> bodies{static_body(Vector3::Zero()), box_body(1.0, {1.0, 0.4, 0.2}, {1, 0, 0})};
    bodies[1].angular_momentum = {0.2, 0.5, -0.3};
    ConstraintRow row = row_along(Vector3::UnitX(), 0.0);
    row.jacobian.b.tail<3>() = Vector3(0.2, 0.3, -0.4);
    const Literal step = step_with(bodies, std::vector{row}, dt);
    CHECK(step.speed_along(0) == Approx(0.0).margin(1e-13));
    const Body& moved = step.bodies[1];
    CHECK(std::abs(row.jacobian.b.dot(stacked(velocity(moved), angular_velocity(moved)))) > 1e-3);
}

TEST_CASE("7.1.1 and 7.2 take the same entry of a symmetric matrix") {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Frozen frozen = tests::random_rows(seed, 4, 12, 1.0);
        const MatrixX A = tests::dense_matrix(frozen.system);
        CHECK((A - A.transpose()).norm() < 1e-12 * A.norm());
        Columns lambda = frozen.zero();
        solvers::make_solver("dense")->solve(frozen.system, {.iterations = 25}, lambda);
        CHECK((solve_as_printed(frozen, 25) - lambda.col(0)).norm() < 1e-9 * (1.0 + lambda.norm()));
    }
}

TEST_CASE("7.2: a row between two static bodies is 0 / 0 as printed, and spoils every row of the system") {
    std::vector<Body> bodies = flying({-3, 1, 0});
    bodies.push_back(static_body({0, 1, 0}));
    std::vector<ConstraintRow> rows(2, row_along(Vector3::UnitX(), 0.0));
    rows[0].body_b = 2;
    rows[0].jacobian = {};  // as every row between static bodies
    const Frozen frozen(bodies, rows, dt);
    CHECK(frozen.system.diagonal[0] == 0.0);
    CHECK(solve_as_printed(frozen, 1).array().isNaN().all());  // zero times NaN spoils the other row
    Columns lambda = frozen.zero();
    solvers::make_solver("dense")->solve(frozen.system, {.iterations = 1}, lambda);
    CHECK(lambda(0, 0) == 0.0);
    CHECK(lambda(1, 0) == Approx(3.0 * 2.0 / dt));

    // So is a bar whose ends coincide, if its axis is p_ab itself (5.2.1).
    std::vector<Body> coincide = flying({0, 0, 0});
    coincide[1].position.setZero();
    const Vector3 p_ab = coincide[1].position - coincide[0].position;
    CHECK(std::isnan(solve_as_printed(Frozen(coincide, std::vector{row_along(p_ab, 0.0)}, dt), 1)[0]));
}

TEST_CASE(
    "9.1: the unit of J is free: a row s times as long has lambda / s, and J v is no work but lambda J v is "
    "power") {
    const std::vector<Body> bodies = flying({-3, 1, 0});
    const auto scaled = [&](double s) {
        ConstraintRow row = row_along(s * Vector3::UnitX(), s * 0.5);
        row.bounds = {.c_min = 0.0, .c_max = 200.0 / s};  // so a limit in newtons belongs to an axis without unit
        return step_with(bodies, std::vector{row}, dt);
    };
    const Literal one = scaled(1.0);
    CHECK(one.lambda(0, 0) == 200.0);
    for (const double s : {0.1, 3.0, 1000.0}) {
        const Literal other = scaled(s);
        CHECK(other.lambda(0, 0) == Approx(one.lambda(0, 0) / s));
        CHECK((other.forces[1] - one.forces[1]).norm() < 1e-10);
        CHECK(other.speed_along(0) == Approx(s * one.speed_along(0)));
        CHECK(other.power() == Approx(one.power()));
        CHECK(other.lambda(0, 0) * other.speed_along(0) == Approx(one.power()));
    }
}

TEST_CASE("10.1: the order of the rows decides what 25 sweeps leave, and nothing of the solution") {
    tests::Problem stack = stack_of_five();
    const auto force_on_top = [&](int iterations) {
        const Frozen frozen = stack.frozen();
        Columns lambda = frozen.zero();
        solvers::make_solver("pgs")->solve(frozen.system, {.iterations = iterations}, lambda);
        std::vector<Vector6> forces;
        constraint_forces(frozen.system, lambda, 0, forces);
        return forces.back();
    };
    const Vector6 some = force_on_top(25), all = force_on_top(20000);
    std::reverse(stack.rows.begin(), stack.rows.end());
    CHECK((force_on_top(25) - some).norm() > 0.1);
    CHECK((force_on_top(20000) - all).norm() < 1e-6);
}

TEST_CASE("12.3.2: J has no inverse: v2 is not J^-1 v, and where rows are redundant J J^-1 is not 1 either") {
    std::vector<Body> bodies{static_body(Vector3::Zero()), ball_body(2.0, 0.1, {1, 0, 0})};
    bodies[1].linear_momentum = {-6, 2, 0};
    const tests::Literal step = tests::step_with(bodies, std::vector{row_along(Vector3::UnitX(), 0.5)}, 0.1);
    MatrixX J(1, 6);
    J.row(0) = step.frozen.rows[0].jacobian.b.transpose();
    CHECK((J * step.after[1])[0] == Approx(0.5));                           // J v2 = v
    const VectorX printed = pseudo_inverse(J) * VectorX::Constant(1, 0.5);  // v2 = J^-1 v
    CHECK((printed - step.after[1]).norm() == Approx(1.0));                 // lacks the flight along the bar's side
    CHECK((J * pseudo_inverse(J) - MatrixX::Identity(1, 1)).norm() < 1e-15);

    MatrixX twice(2, 6);
    twice << J, J;
    CHECK((twice * pseudo_inverse(twice) - MatrixX::Identity(2, 2)).norm() == Approx(1.0));
}
