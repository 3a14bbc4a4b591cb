// Claims that `nncg` and `jacobi` share with `pgs`: the same solutions, the same contract (paper section 7).
#include "tests/catch.h"
#include "tests/engine/solvers/problems.h"

using namespace pushfactor::engine;
using namespace pushfactor::tests;
using solvers::make_solver;

namespace {

constexpr solvers::Termination to_the_end{.iterations = 200000, .tolerance_high = 1e-12, .tolerance_low = 1e-12};

// The largest difference of a body's change of velocity [m/s, rad/s], which is unique where lambda is not.
double difference(const SystemEquation& system, const Columns& one, const Columns& other) {
    double largest = 0.0;
    std::vector<Vector6> forces;
    for (Eigen::Index c = 0; c < system.column_count(); ++c) {
        constraint_forces(system, one - other, c, forces);
        for (std::size_t i = 0; i < forces.size(); ++i) {
            const Vector6 change = system.dt * accelerate(system.inverse_mass[i], forces[i]);
            largest = std::max(largest, change.cwiseAbs().maxCoeff());
        }
    }
    return largest;
}

bool within_bounds(const SystemEquation& system, const Columns& lambda) {
    for (Eigen::Index c = 0; c < lambda.cols(); ++c) {
        for (Eigen::Index j = 0; j < lambda.rows(); ++j) {
            const auto [low, high] = bounds_of(system.rows[static_cast<std::size_t>(j)], lambda, c);
            if (!(lambda(j, c) >= low && lambda(j, c) <= high)) return false;
        }
    }
    return true;
}

}  // namespace

TEST_CASE("all sweeping solvers come to the answer of pgs, within the bounds") {
    for (const Problem& problem : solvable_problems()) {
        const Frozen frozen = problem.frozen();
        const Columns reference = solve("pgs", frozen.system, frozen.zero(), to_the_end);
        REQUIRE(natural_residual(frozen.system, reference) < 1e-11);
        for (const char* solver : {"nncg", "jacobi"}) {
            INFO(problem.name << ", " << solver << ", rows " << frozen.system.row_count());
            const Columns lambda = solve(solver, frozen.system, frozen.zero(), to_the_end);
            CHECK(natural_residual(frozen.system, lambda) < 1e-9);
            CHECK(difference(frozen.system, lambda, reference) < 1e-9);
            CHECK(within_bounds(frozen.system, lambda));
        }
    }
}

TEST_CASE("answers lie within the bounds after any number of iterations, with any guess") {
    for (const Problem& problem : solvable_problems()) {
        const Frozen frozen = problem.frozen();
        for (const char* solver : {"nncg", "jacobi"}) {
            for (const double tolerance : {0.0, 1e-12}) {
                for (int iterations = 1; iterations <= 12; ++iterations) {
                    INFO(problem.name << ", " << solver << ", " << iterations);
                    const Columns lambda =
                        solve(solver, frozen.system, frozen.zero().array() - 3.0,
                              {.iterations = iterations, .tolerance_high = tolerance, .tolerance_low = tolerance});
                    REQUIRE(within_bounds(frozen.system, lambda));
                }
            }
        }
    }
}

TEST_CASE("a row that can move nothing gets no force from any sweeping solver") {
    Problem problem = column_problem(3);
    ConstraintRow idle;  // between the ground and itself: A_jj = 0
    idle.push.lasting = 1.0;
    problem.rows.insert(problem.rows.begin() + 1, idle);
    const Frozen frozen = problem.frozen();
    for (const char* solver : {"nncg", "jacobi"}) {
        const Columns lambda = solve(solver, frozen.system, frozen.zero().array() + 1.0, {.iterations = 2000});
        CHECK(lambda(0, 0) == Approx(30.0));
        CHECK(lambda(1, 0) == 0.0);
        CHECK(lambda(2, 0) == Approx(20.0));
    }
}

TEST_CASE("each of two columns is solved as if it were alone") {
    const Problem problem = tower_problem("tower", 3, 0.0, pushfactor::engine::coulomb_friction, single_frame);
    const Frozen frozen = problem.frozen();
    REQUIRE(frozen.system.column_count() == 2);
    for (const char* solver : {"nncg", "jacobi"}) {
        const Columns both = solve(solver, frozen.system, frozen.zero(), {.iterations = 40});
        CHECK(both.col(0) != both.col(1));
        for (Eigen::Index c = 0; c < 2; ++c) {
            SystemEquation alone = frozen.system;
            alone.b = frozen.system.b.col(c).eval();
            const Columns one = solve(solver, alone, Columns::Zero(alone.row_count(), 1), {.iterations = 40});
            CHECK((one - both.col(c)).cwiseAbs().maxCoeff() < 1e-9 * both.col(c).cwiseAbs().maxCoeff());
        }
    }
}

TEST_CASE("sweeping solvers keep a guess within the upper tolerance and work a worse one down to the lower") {
    const Frozen frozen = column_problem(5).frozen();
    Columns guess = frozen.zero();
    for (int i = 0; i < 5; ++i) guess(i, 0) = 10.0 * (5 - i);
    guess(4, 0) += 0.01;  // wrong by dt A 0.01 N = 3.3e-4 m/s
    for (const char* name : {"nncg", "jacobi"}) {
        const auto solver = make_solver(name);
        Columns lambda = guess;
        solvers::Termination termination{.iterations = 2000, .tolerance_high = 1e-3, .tolerance_low = 1e-9};
        CHECK(solver->solve(frozen.system, termination, lambda).iterations == 0);
        CHECK(lambda == guess);
        termination.tolerance_high = 1e-4;
        const int taken = solver->solve(frozen.system, termination, lambda).iterations;
        CHECK(taken > 4);
        CHECK(taken < 2000);
        CHECK(natural_residual(frozen.system, lambda) <= 1e-9);
        CHECK(solver->solve(frozen.system, {.iterations = 7}, lambda).iterations == 7);
    }
}

TEST_CASE("on columns nncg needs fewer iterations than pgs, and jacobi more") {
    for (const int n : {5, 10, 20}) {
        const Frozen frozen = column_problem(n).frozen();
        const auto iterations = [&](const char* solver) {
            Columns lambda = frozen.zero();
            return make_solver(solver)
                ->solve(frozen.system, {.iterations = 100000, .tolerance_high = 1e-10, .tolerance_low = 1e-10},
                        lambda)
                .iterations;
        };
        INFO(n << " balls: nncg " << iterations("nncg") << ", pgs " << iterations("pgs") << ", jacobi "
               << iterations("jacobi"));
        CHECK(2 * iterations("nncg") < iterations("pgs"));
        CHECK(2 * iterations("pgs") < iterations("jacobi"));
        CHECK(iterations("jacobi") < 100000);
    }
}

TEST_CASE("work is the same for equal runs, and every iteration but the first costs the same") {
    const Frozen frozen = tower_problem("tower", 3, 0.0, weight_friction(), single_frame).frozen();
    for (const char* name : {"pgs", "nncg", "jacobi"}) {
        const auto solver = make_solver(name);
        const auto work = [&](int iterations) {
            Columns lambda = frozen.zero();
            return solver->solve(frozen.system, {.iterations = iterations}, lambda).multiply_adds;
        };
        CHECK(work(25) == work(25));
        CHECK(work(101) - work(100) == work(2) - work(1));
        CHECK(work(100) - work(1) == 99 * (work(2) - work(1)));
        // 24 per row for the sweep; nncg adds at most two thirds of another.
        const double sweep = 24.0 * static_cast<double>(frozen.system.row_count() * frozen.system.column_count());
        CHECK(work(1) == sweep);
        CHECK(work(2) - work(1) >= sweep);
        CHECK(work(2) - work(1) < 1.67 * sweep);
    }
}
