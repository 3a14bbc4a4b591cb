// The conjugate sweeps against the published method on the dense A, and the additional guarantees of `nncg`.
#include "tests/catch.h"
#include "tests/engine/solvers/problems.h"

using namespace pushfactor::engine;
using namespace pushfactor::tests;

namespace {

// The published method, with A and A_jj as they are and directions in lambda sqrt(A_jj). For systems of one column.
// `restarts` counts how often beta was above 1.
Columns dense_nncg(const SystemEquation& system, int iterations, int& restarts) {
    const MatrixX A = dense_matrix(system);
    const VectorX scale = system.diagonal.cwiseSqrt();
    Columns lambda = Columns::Zero(A.rows(), 1);
    VectorX p;
    double last_length = 0.0;
    for (int k = 0; k < iterations; ++k) {
        const VectorX before = lambda.col(0);
        for (Eigen::Index j = 0; j < A.rows(); ++j) {
            if (A(j, j) <= 0.0) continue;
            const double value = lambda(j, 0) + (system.b(j, 0) - A.row(j).dot(lambda.col(0))) / A(j, j);
            const auto [low, high] = bounds_of(system.rows[static_cast<std::size_t>(j)], lambda, 0);
            lambda(j, 0) = std::max(std::min(value, high), low);
        }
        if (k + 1 == iterations) break;
        const VectorX r = lambda.col(0) - before;
        const double length = r.cwiseProduct(scale).squaredNorm();
        if (k == 0) {
            p = r;
        } else if (length > last_length) {
            p.setZero();
            ++restarts;
        } else {
            lambda.col(0) += length / last_length * p;
            p = length / last_length * p + r;
        }
        last_length = length;
    }
    return lambda;
}

Problem tower(int count) {
    return tower_problem("tower", count, 0.0, weight_friction(), persistent);
}

double residual(const Frozen& frozen, const Columns& guess, const solvers::Termination& termination) {
    return natural_residual(frozen.system, solve("nncg", frozen.system, guess, termination));
}

}  // namespace

TEST_CASE("nncg is the published method on the dense A") {
    std::vector<Problem> problems = solvable_problems();
    problems.push_back(tower(5));
    int compared = 0, restarts = 0;
    for (const Problem& problem : problems) {
        const Frozen frozen = problem.frozen();
        const bool discs = std::any_of(frozen.rows.begin(), frozen.rows.end(),
                                       [](const ConstraintRow& row) { return row.bounds.disc != Disc::none; });
        if (frozen.system.column_count() != 1 || discs) continue;
        ++compared;
        for (const int iterations : {1, 2, 3, 12}) {
            INFO(problem.name << ", " << iterations);
            const Columns dense = dense_nncg(frozen.system, iterations, restarts);
            const Columns sparse = solve("nncg", frozen.system, frozen.zero(), {.iterations = iterations});
            CHECK((sparse - dense).cwiseAbs().maxCoeff() <= 1e-10 * dense.cwiseAbs().maxCoeff());
        }
    }
    CHECK(compared == 8);
    CHECK(restarts > 0);
}

TEST_CASE("the first two iterations of nncg are those of pgs, bit for bit: there is nothing to go on with yet") {
    const Frozen frozen = tower(4).frozen();
    for (const int iterations : {1, 2}) {
        CHECK(solve("nncg", frozen.system, frozen.zero(), {.iterations = iterations}) ==
              solve("pgs", frozen.system, frozen.zero(), {.iterations = iterations}));
    }
    CHECK(solve("nncg", frozen.system, frozen.zero(), {.iterations = 3}) !=
          solve("pgs", frozen.system, frozen.zero(), {.iterations = 3}));
}

TEST_CASE("the velocities of the bodies stay those of the forces over thousands of iterations") {
    CHECK(residual(tower(2).frozen(), tower(2).frozen().zero(), {.iterations = 5000}) < 1e-13);
    CHECK(residual(tower(5).frozen(), tower(5).frozen().zero(), {.iterations = 5000}) < 1e-12);
}

TEST_CASE("on a tower nncg is ahead of pgs from 25 iterations on") {
    const Frozen frozen = tower(5).frozen();
    for (const int iterations : {25, 100, 400}) {
        const Columns pgs = solve("pgs", frozen.system, frozen.zero(), {.iterations = iterations});
        INFO(iterations);
        CHECK(residual(frozen, frozen.zero(), {.iterations = iterations}) <
              0.5 * natural_residual(frozen.system, pgs));
    }
}

TEST_CASE("with tolerances nncg returns nothing worse than its guess, where without it may") {
    int worse = 0;
    for (const Problem& problem : solvable_problems()) {
        const Frozen frozen = problem.frozen();
        for (int before = 1; before <= 30; ++before) {
            const Columns guess = solve("nncg", frozen.system, frozen.zero(), {.iterations = before});
            const double start = natural_residual(frozen.system, guess);
            for (int iterations = 1; iterations <= 20; ++iterations) {
                if (residual(frozen, guess, {.iterations = iterations}) > 1.01 * start) ++worse;
                const solvers::Termination checked{
                    .iterations = iterations, .tolerance_high = 1e-15, .tolerance_low = 1e-15};
                INFO(problem.name << ", " << before << " and " << iterations);
                REQUIRE(residual(frozen, guess, checked) <= start * (1.0 + 1e-9) + 1e-14);
            }
        }
    }
    CHECK(worse > 0);
}

TEST_CASE("a guess outside the bounds counts as what the bounds make of it") {
    const Frozen frozen = column_problem(2).frozen();
    Columns guess = frozen.zero();
    guess << 20.0, 10.0;
    CHECK(natural_residual(frozen.system, guess) < 1e-15);
    Problem given = column_problem(2);
    given.rows[1].bounds.c_max = 9.0;  // the answer is now 19 and 9
    const Frozen limited = given.frozen();
    const Columns lambda =
        solve("nncg", limited.system, guess, {.iterations = 200, .tolerance_high = 1e-12, .tolerance_low = 1e-12});
    CHECK(lambda(0, 0) == Approx(19.0));
    CHECK(lambda(1, 0) == 9.0);
}
