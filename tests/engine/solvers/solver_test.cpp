// Paper section 7: the sweep against the dense A, against theory, and against the definition of a solution.
#include "engine/solvers/solver.h"

#include "engine/base/invalid_input.h"
#include "engine/constraints/contact_constraints.h"
#include "tests/catch.h"
#include "tests/engine/rows.h"
#include "tests/scene_fixture.h"
#include "tests/settings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace pushfactor;
using namespace pushfactor::engine;
using pushfactor::tests::Column;
using pushfactor::tests::Frozen;
using solvers::make_solver;

namespace {

constexpr double dt = 1.0 / 60.0;

Columns solved(const char* solver, const SystemEquation& system, Columns lambda,
               const solvers::Termination& termination) {
    make_solver(solver)->solve(system, termination, lambda);
    return lambda;
}

// The largest difference of a row between the solvers, relative to the largest force (at least a nanonewton).
double difference(const SystemEquation& system, const Columns& guess, int iterations) {
    const Columns sparse = solved("pgs", system, guess, {.iterations = iterations});
    const Columns dense = solved("dense", system, guess, {.iterations = iterations});
    return (sparse - dense).cwiseAbs().maxCoeff() / std::max(1e-9, dense.cwiseAbs().maxCoeff());
}

Columns guesses(const World& world) {
    Columns lambda(world.system().row_count(), world.system().column_count());
    for (Eigen::Index j = 0; j < lambda.rows(); ++j) {
        lambda(j, 0) = world.rows()[static_cast<std::size_t>(j)].guess.first;
        lambda(j, lambda.cols() - 1) = world.rows()[static_cast<std::size_t>(j)].guess.last;
    }
    return lambda;
}

}  // namespace

TEST_CASE("after 25 iterations sweep and dense A agree to 1e-12 relative, row for row") {
    for (const char* preset : {"paper", "default"}) {
        for (const auto model :
             {demos::FrictionModel::paper, demos::FrictionModel::coulomb, demos::FrictionModel::cone}) {
            demos::Settings settings = tests::awake_settings(preset);
            settings.friction_model = model;
            auto simulation = tests::simulate("intersecting-stack", settings);
            int compared = 0;
            for (int step = 0; step < 40; ++step) {
                simulation.advance();
                const World& world = simulation.scene().world;
                if (world.system().row_count() == 0) continue;
                ++compared;
                const SystemEquation& system = world.system();
                REQUIRE(difference(system, Columns::Zero(system.row_count(), system.column_count()), 25) < 1e-12);
                REQUIRE(difference(system, guesses(world), 25) < 1e-12);
            }
            CHECK(compared > 2);
        }
    }
}

TEST_CASE("on a column of n bodies the sweep's error shrinks by cos^2(pi / 2n) an iteration") {
    for (const int n : {5, 10, 20}) {
        const Column column(n);
        const Frozen frozen(column.bodies, column.rows, dt);
        Columns exact = frozen.zero();
        for (int i = 0; i < n; ++i) exact(i, 0) = 10.0 * (n - i);
        const auto error = [&](int k) {
            return (solved("pgs", frozen.system, frozen.zero(), {.iterations = k}) - exact).norm();
        };
        const double rate = std::pow(std::cos(std::numbers::pi / (2.0 * n)), 2);
        CHECK(error(8 * n + 1) / error(8 * n) == Approx(rate).epsilon(1e-3));
    }
}

TEST_CASE("a solution keeps its bounds and errs only where a bound holds it, in both columns") {
    auto simulation =
        tests::simulate("intersecting-stack", tests::solved_exactly(tests::awake_settings("default")));
    tests::advance(simulation, 0.1);
    const World& world = simulation.scene().world;
    const SystemEquation& system = world.system();
    for (const char* solver : {"pgs", "dense"}) {
        const Columns lambda = solved(solver, system, guesses(world),
                                      {.iterations = 20000, .tolerance_high = 1e-13, .tolerance_low = 1e-13});
        CHECK(natural_residual(system, lambda) < 1e-12);
        for (Eigen::Index c = 0; c < lambda.cols(); ++c) {
            for (Eigen::Index j = 0; j < lambda.rows(); ++j) {
                const auto [low, high] = bounds_of(system.rows[static_cast<std::size_t>(j)], lambda, c);
                REQUIRE(lambda(j, c) >= low);
                REQUIRE(lambda(j, c) <= high);
            }
        }
    }
}

TEST_CASE("a row that can move nothing gets no force, and spoils no other") {
    Column column(3);
    ConstraintRow idle;  // between the ground and itself: A_jj = 0
    idle.push.lasting = 1.0;
    column.rows.insert(column.rows.begin() + 1, idle);
    const Frozen frozen(column.bodies, column.rows, dt);
    for (const char* solver : {"pgs", "dense"}) {
        const Columns lambda = solved(solver, frozen.system, frozen.zero(), {.iterations = 500});
        CHECK(lambda(0, 0) == Approx(30.0));
        CHECK(lambda(1, 0) == 0.0);
        CHECK(lambda(2, 0) == Approx(20.0));
    }
}

TEST_CASE("a guess within the upper tolerance is kept, a worse one is worked down to the lower") {
    const Column column(5);
    const Frozen frozen(column.bodies, column.rows, dt);
    Columns guess = frozen.zero();
    for (int i = 0; i < 5; ++i) guess(i, 0) = 10.0 * (5 - i);
    guess(4, 0) += 0.01;  // wrong by dt A 0.01 N = 3.3e-4 m/s

    for (const char* name : {"pgs", "dense"}) {
        const auto solver = make_solver(name);
        Columns lambda = guess;
        CHECK(
            solver
                ->solve(frozen.system, {.iterations = 1000, .tolerance_high = 1e-3, .tolerance_low = 1e-9}, lambda)
                .iterations == 0);
        CHECK(lambda == guess);
        const int sweeps =
            solver
                ->solve(frozen.system, {.iterations = 1000, .tolerance_high = 1e-4, .tolerance_low = 1e-9}, lambda)
                .iterations;
        CHECK(sweeps > 10);
        CHECK(sweeps < 1000);
        CHECK(natural_residual(frozen.system, lambda) <= 1e-9);
        CHECK(solver->solve(frozen.system, {.iterations = 7}, lambda).iterations ==
              7);  // tolerance 0: always all of them
    }
}

TEST_CASE("a force limit is kept and the rest of the rows do what they can") {
    Column column(2);
    column.rows[0].bounds.c_max = 15.0;  // the ground can carry one and a half of the two
    const Frozen frozen(column.bodies, column.rows, dt);
    const Columns lambda = solved("pgs", frozen.system, frozen.zero(), {.iterations = 2000});
    CHECK(lambda(0, 0) == 15.0);
    CHECK(lambda(1, 0) == Approx(7.5));  // both sink together at 2.5 m/s^2
}

TEST_CASE("an unknown solver is refused with the names of those that there are") {
    CHECK_THROWS_AS(make_solver("magic"), InvalidInput);
    CHECK_THROWS_WITH(make_solver("magic"), Catch::Contains("pgs") && Catch::Contains("dense"));
}
