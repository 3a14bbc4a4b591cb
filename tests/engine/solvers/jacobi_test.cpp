// The Jacobi method against itself on the dense A, against theory, and where it fails (paper section 7.1).
#include "engine/solvers/jacobi.h"

#include "tests/catch.h"
#include "tests/engine/solvers/problems.h"

#include <cmath>
#include <numbers>

using namespace pushfactor::engine;
using namespace pushfactor::tests;
using solvers::jacobi_weight;

namespace {

// 7.1.1 with weight `weight` for all rows at once, on the dense A. For systems of one column.
Columns dense_jacobi(const SystemEquation& system, double weight, int iterations) {
    const MatrixX A = dense_matrix(system);
    Columns lambda = Columns::Zero(A.rows(), 1);
    for (int k = 0; k < iterations; ++k) {
        const Columns last = lambda;
        const VectorX error = system.b.col(0) - A * last.col(0);
        for (Eigen::Index j = 0; j < A.rows(); ++j) {
            if (A(j, j) <= 0.0) continue;
            const auto [low, high] = bounds_of(system.rows[static_cast<std::size_t>(j)], last, 0);
            lambda(j, 0) = std::max(std::min(last(j, 0) + weight * error[j] / A(j, j), high), low);
        }
    }
    return lambda;
}

double residual_after(const char* solver, const Frozen& frozen, int iterations) {
    return natural_residual(frozen.system, solve(solver, frozen.system, frozen.zero(), {.iterations = iterations}));
}

Problem tower(double turn, const ContactChoices& choices) {
    return tower_problem("tower", 5, turn, weight_friction(), choices);
}

}  // namespace

TEST_CASE("jacobi is 7.1.1 for all rows at once on the dense A, relaxed") {
    for (const Problem& problem : solvable_problems()) {
        const Frozen frozen = problem.frozen();
        if (frozen.system.column_count() != 1) continue;
        INFO(problem.name);
        for (const int iterations : {1, 2, 25}) {
            Columns dense = dense_jacobi(frozen.system, jacobi_weight, iterations);
            // A bound that follows another row is applied again when the solution is stored.
            for (Eigen::Index j = 0; j < dense.rows(); ++j) {
                const auto [low, high] = bounds_of(frozen.rows[static_cast<std::size_t>(j)], dense, 0);
                dense(j, 0) = std::max(std::min(dense(j, 0), high), low);
            }
            const Columns sparse = solve("jacobi", frozen.system, frozen.zero(), {.iterations = iterations});
            CHECK((sparse - dense).cwiseAbs().maxCoeff() <= 1e-12 * dense.cwiseAbs().maxCoeff());
        }
    }
}

TEST_CASE("on a column of n bodies jacobi's error shrinks by 1 - w (1 - cos(pi / 2n)) an iteration") {
    for (const int n : {5, 10}) {
        const Frozen frozen = column_problem(n).frozen();
        Columns exact = frozen.zero();
        for (int i = 0; i < n; ++i) exact(i, 0) = 10.0 * (n - i);
        const auto error = [&](int k) {
            return (solve("jacobi", frozen.system, frozen.zero(), {.iterations = k}) - exact).norm();
        };
        const double rate = 1.0 - jacobi_weight * (1.0 - std::cos(std::numbers::pi / (2.0 * n)));
        CHECK(1.0 - error(20 * n + 1) / error(20 * n) == Approx(1.0 - rate).epsilon(1e-3));
    }
}

TEST_CASE(
    "where faces touch in four points plain Jacobi is worse than nothing, the relaxed one gets there slowly") {
    const Frozen frozen = tower(0.0, persistent).frozen();
    const double eigenvalue = largest_eigenvalue(frozen.system);
    CHECK(eigenvalue > 2.0);                  // weight 1 cannot converge
    CHECK(eigenvalue < 2.0 / jacobi_weight);  // ours does
    const double nothing = natural_residual(frozen.system, frozen.zero());
    for (const int iterations : {10, 25, 100}) {
        INFO(iterations);
        CHECK(natural_residual(frozen.system, dense_jacobi(frozen.system, 1.0, iterations)) > nothing);
        CHECK(residual_after("jacobi", frozen, iterations) < nothing);
        CHECK(residual_after("jacobi", frozen, iterations) > residual_after("pgs", frozen, iterations));
    }
}

TEST_CASE("where faces touch in eight points jacobi does not converge, but its forces stay bounded") {
    const Frozen frozen = tower(std::numbers::pi / 4.0, pushed(PushKind::persistent, false)).frozen();
    REQUIRE(frozen.rows.size() == 3 * (4 + 4 * 8));
    CHECK(largest_eigenvalue(frozen.system) > 2.0 / jacobi_weight);
    CHECK(residual_after("jacobi", frozen, 1000) > 0.1);
    const Columns lambda = solve("jacobi", frozen.system, frozen.zero(), {.iterations = 10000});
    CHECK(lambda.allFinite());
    CHECK(lambda.cwiseAbs().maxCoeff() < 1000.0);  // the five cubes weigh 50 N
    CHECK(residual_after("pgs", frozen, 1000) < 1e-2);
}

TEST_CASE("seven equal rows without bounds are one too many for jacobi") {
    for (const int count : {6, 7}) {
        Problem problem = chain_problem(1);
        problem.rows.resize(static_cast<std::size_t>(count), problem.rows[0]);
        const Frozen frozen = problem.frozen();
        CHECK(largest_eigenvalue(frozen.system) == Approx(count));
        const double after = residual_after("jacobi", frozen, 200);
        CHECK((count == 6 ? after < 1e-12 : after > 1e6));
    }
}
