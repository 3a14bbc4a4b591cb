// Which solver to choose, as the README says: orderings of errors by work, which is counted in multiply-adds and
// the same on every machine. The measured numbers are in comments; no test depends on times.
#include "demos/reports/error/error.h"
#include "engine/solvers/solver.h"
#include "tests/catch.h"

#include <algorithm>
#include <string>

using namespace pushfactor;
using namespace pushfactor::demos;
using namespace pushfactor::demos::reports::error;

namespace {

struct Cost {
    double error = 0.0;
    double work = 0.0;  // multiply-adds
};

// The first error of a run, and the work of all its steps.
Cost cost_of(const std::string& scene, const OptionTexts& options, const MakeTrueError& make) {
    const Choices choices = run_of(scene, options);
    Simulation run(choices);
    TrueError error = make(run);
    Cost cost;
    while (run.sample().step < whole_steps(choices.settings)) {
        run.advance();
        error.observe(run);
        cost.work += run.sample().count.multiply_adds;
    }
    cost.error = error.result().front().value;
    return cost;
}

FrozenMoment moment_of(const std::string& name) {
    for (const FrozenMoment& moment : hard_moments(false)) {
        if (moment.name == name) return moment;
    }
    FAIL("no moment " << name);
    return {};
}

// The residual after exactly that many iterations.
Cost solve(const FrozenProblem& problem, std::string_view solver, bool warm, int iterations) {
    engine::Columns lambda = warm ? problem.guess() : problem.zero();
    const auto count = engine::solvers::make_solver(solver)->solve(
        problem.system(), {.iterations = iterations, .tolerance_high = 0.0, .tolerance_low = 0.0}, lambda);
    return {natural_residual(problem.system(), lambda), count.multiply_adds};
}

}  // namespace

// Auto takes what lands in small steps, which are no whole steps solved to rounding.
TEST_CASE("a stack: direct reaches rounding for less work than sweeps leave centimetres with") {
    const auto fall = [](OptionTexts options) {
        options.insert(options.end(), {{"jitter", "0.01"},
                                       {"seed", "1"},
                                       {"slop", "0"},
                                       {"gap", "0.05"},
                                       {"friction-model", "paper"},
                                       {"seconds", "4"}});
        return cost_of("stack", options, rest_error);
    };
    const Cost many = fall({{"solver", "pgs"}, {"tolerance", "0"}, {"iterations", "25"}});
    CHECK(many.error > 1e-3);
    const Cost exact = fall({{"solver", "direct"}, {"tolerance", "1e-10"}});
    CHECK(exact.error < 1e-9);
    CHECK(exact.work < 0.25 * many.work);
}

TEST_CASE(
    "stacks, chains and the grid: direct leaves nothing for the work of a hundred sweeps, in a landing of a "
    "hundred cubes of four hundred") {
    for (const auto& [name, warm] :
         {std::pair{"stack of 5, landing", true}, std::pair{"stack of 20, landing", true},
          std::pair{"stack of 100, landing", true}, std::pair{"chain of 5, end 1000 times heavier", false},
          std::pair{"chain of 20, end 1000 times heavier", false}, std::pair{"pendulum grid", false}}) {
        INFO(name);
        const FrozenProblem problem = freeze(moment_of(name), [] {});
        for (const char* solver : {"direct", "auto"}) {
            const Cost exact = solve(problem, solver, warm, 100);
            CHECK(exact.error < 1e-11);
            for (const char* sweeping : {"pgs", "jacobi", "nncg"}) {
                INFO(sweeping);
                const Cost sweeps = solve(problem, sweeping, warm, 100);
                CHECK(exact.work < (name == std::string("stack of 100, landing") ? 4.0 : 1.0) * sweeps.work);
                CHECK(sweeps.error > 5e-6);
            }
        }
    }
}

TEST_CASE("a heap: sweeps from the last forces are enough, and auto takes them") {
    const FrozenProblem heap = freeze(moment_of("funnel of 200"), [] {});
    const Cost sweeps = solve(heap, "pgs", true, 25);
    // What the step says that an exact solution of something that moves is worth.
    engine::Columns lambda = heap.guess();
    const engine::solvers::Termination moving{.iterations = 25, .worth = 64.0 * sweeps.work / 25.0};
    CHECK(engine::solvers::make_solver("auto")->solve(heap.system(), moving, lambda).multiply_adds == sweeps.work);
    CHECK(sweeps.error < 1e-6);
    CHECK(solve(heap, "direct", true, 1).work > 2.0 * sweeps.work);
    CHECK(solve(heap, "direct", false, 25).work > 10.0 * solve(heap, "pgs", false, 25).work);
}

TEST_CASE("a mass ratio of 1000: sweeps leave what direct does not, for more work") {
    const auto stand = [](const OptionTexts& options) {
        OptionTexts all{{"mass-ratio", "1000"}, {"seconds", "2"}, {"slop", "0"}};
        all.insert(all.end(), options.begin(), options.end());
        return cost_of("heavy-on-light", all, rest_error);
    };
    const Cost exact = stand({{"solver", "direct"}});
    const Cost sweeps = stand({{"solver", "pgs"}, {"tolerance", "0"}, {"iterations", "25"}});
    CHECK(exact.error < 1e-8);
    CHECK(sweeps.error > 1e-2);
    CHECK(exact.work < sweeps.work);
}

TEST_CASE("swinging bars: the step decides and not the solver, and composed steps give more digits for the work") {
    const auto swing = [](const std::string& dt, const OptionTexts& options) {
        OptionTexts all{{"count", "10"}, {"seconds", "10"}, {"dt", dt}};
        all.insert(all.end(), options.begin(), options.end());
        return cost_of("pendulum-wave", all, scene_error);
    };
    const Cost coarse = swing("1/60", {}), fine = swing("1/480", {});
    for (const char* solver : {"pgs", "nncg", "direct"}) {
        INFO(solver);
        CHECK(swing("1/60", {{"solver", solver}}).error == Approx(coarse.error).epsilon(1e-4));
    }
    const Cost late = swing("1/240", {{"start-kick", "off"}});
    CHECK(coarse.error < late.error);
    CHECK(coarse.work < 0.5 * late.work);

    const Cost fourth = swing("1/60", {{"scheme", "rattle4"}});
    CHECK(fourth.error < fine.error);
    CHECK(fourth.work < 4.0 * fine.work);
    const Cost finest = swing("1/960", {});
    CHECK(fourth.error < finest.error);
    CHECK(fourth.work < finest.work);
    // Where few digits suffice a composed step does not pay.
    CHECK(coarse.work < 0.2 * fourth.work);
}

TEST_CASE("from zero a conjugate sweep leaves less than a sweep, and a sweep less than Jacobi") {
    for (const char* name : {"stack of 5, landing", "stack of 5, settled", "stack of 20, settled",
                             "chain of 20, end 1000 times heavier", "column of 10 spheres"}) {
        INFO(name);
        const FrozenProblem problem = freeze(moment_of(name), [] {});
        const Cost nncg = solve(problem, "nncg", false, 250), pgs = solve(problem, "pgs", false, 1000);
        CHECK(nncg.error < pgs.error);
        CHECK(nncg.work < pgs.work);
        const Cost jacobi = solve(problem, "jacobi", false, 25), sweeps = solve(problem, "pgs", false, 25);
        CHECK(jacobi.work == sweeps.work);
        CHECK(sweeps.error < jacobi.error);
    }
}
