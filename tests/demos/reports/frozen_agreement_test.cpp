// Every solver on every frozen problem of the report, against the direct one.
#include "demos/reports/error/error.h"
#include "demos/scenes/families/family.h"
#include "engine/solvers/solver.h"
#include "tests/catch.h"
#include "tests/settings.h"

#include <algorithm>
#include <set>

using namespace pushfactor;
using namespace pushfactor::demos;
using namespace pushfactor::demos::reports::error;

namespace {

constexpr double converged = 1e-9;  // m/s

struct Answer {
    engine::Columns lambda;
    double residual = 0.0;
    int iterations = 0;
};

// With tolerance 0.
Answer answer(const FrozenProblem& problem, std::string_view solver, bool warm, int iterations) {
    Answer found{warm ? problem.guess() : problem.zero()};
    found.iterations =
        engine::solvers::make_solver(solver)
            ->solve(problem.system(), {.iterations = iterations, .tolerance_high = 0.0, .tolerance_low = 0.0},
                    found.lambda)
            .iterations;
    found.residual = natural_residual(problem.system(), found.lambda);
    return found;
}

}  // namespace

TEST_CASE("the frozen problems are those that the report promises") {
    std::set<std::string> names;
    for (const FrozenMoment& moment : hard_moments(false)) CHECK(names.insert(moment.name).second);
    for (const char* count : {"5", "20", "100"}) {
        CHECK(names.count(std::string("stack of ") + count + ", landing") == 1);
        CHECK(names.count(std::string("stack of ") + count + ", settled") == 1);
    }
    for (const char* name : {"funnel of 20", "funnel of 200", "pendulum grid", "chain of 5, end 1000 times heavier",
                             "chain of 20, end 1000 times heavier", "column of 10 spheres"}) {
        INFO(name);
        CHECK(names.count(name) == 1);
    }
    for (const FrozenMoment& moment : hard_moments(true)) CHECK(names.count(moment.name) == 1);
}

TEST_CASE("each solver that converges on a frozen problem gives the accelerations of direct") {
    int compared = 0;
    for (const FrozenMoment& moment : hard_moments(false)) {
        INFO(moment.name);
        const FrozenProblem problem = freeze(moment, [] {});
        const Answer warm = answer(problem, "direct", true, 100), cold = answer(problem, "direct", false, 100);
        const Answer& direct = warm.residual < cold.residual ? warm : cold;
        CHECK(direct.residual < converged);
        // Forces of boxes are not unique; their effect on the bodies is, and the force error measures only that.
        for (const engine::solvers::SolverEntry& entry : engine::solvers::solver_table()) {
            if (entry.name == "dense" && problem.system().row_count() > 100) continue;
            for (const bool from_guess : {false, true}) {
                const Answer own = answer(problem, entry.name, from_guess, 500);
                if (own.residual >= converged) continue;
                INFO(entry.name << (from_guess ? ", warm: " : ", cold: ") << own.residual);
                ++compared;
                CHECK(force_error(problem.system(), own.lambda, direct.lambda).value_or(0.0) < 1e-6);
            }
        }
    }
    CHECK(compared > 50);
}

TEST_CASE("with tolerance 0 direct and auto end at rounding, from the last forces") {
    for (const FrozenMoment& moment : hard_moments(false)) {
        INFO(moment.name);
        const FrozenProblem problem = freeze(moment, [] {});
        for (const char* solver : {"direct", "auto"}) {
            const Answer own = answer(problem, solver, true, 100);
            INFO(solver);
            const bool swept = moment.name.starts_with("funnel") && solver == std::string("auto");  // a heap
            CHECK(own.residual < (swept ? 4e-4 : 1e-11));  // measured 1.8e-4
            CHECK(own.iterations > 0);
        }
    }
}

TEST_CASE("direct solves the systems of heaps with friction on the cone from zero") {
    for (const char* const family : {"cubes", "mixed"}) {
        for (const int seed : {1, 2, 3}) {
            for (const double seconds : {0.5, 1.0}) {
                INFO(family << " " << seed << " at " << seconds << " s");
                Choices choices;
                choices.settings = tests::awake_settings("default");
                choices.description =
                    draw_member(*families::find_family(family), {.seed = seed, .given = {{"count", "40"}}})
                        .prospect.scene;
                choices.settings.scheme = Scheme::whole;
                choices.settings.friction_model = FrictionModel::cone;
                choices.settings.seconds = seconds;
                const FrozenProblem problem = freeze(family, choices, [] {});
                engine::Columns lambda = problem.zero();
                engine::solvers::make_solver("direct")->solve(
                    problem.system(), {.iterations = 1000, .tolerance_high = 1e-9, .tolerance_low = 1e-9}, lambda);
                CHECK(natural_residual(problem.system(), lambda) <= 1e-8);
            }
        }
    }
}
