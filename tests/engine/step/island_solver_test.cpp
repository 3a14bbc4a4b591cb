// The guard around a solver. Each rule is tested with a solver that breaks it.
#include "engine/step/island_solver.h"

#include "engine/bodies/diagnostics.h"
#include "tests/catch.h"
#include "tests/engine/random_contacts.h"
#include "tests/engine/solvers/problems.h"
#include "tests/scene_fixture.h"
#include "tests/settings.h"

#include <functional>
#include <limits>

using namespace pushfactor;
using namespace pushfactor::engine;
using tests::Frozen;

namespace {

constexpr solvers::Termination usual{.iterations = 25, .tolerance_high = 1e-8, .tolerance_low = 1e-10};

// A fake solver: changes the forces of an island and reports as told.
class Puppet : public solvers::Solver {
  public:
    using Act = std::function<solvers::SolveCount(const SystemEquation&, const Island&, const solvers::Termination&,
                                                  Columns&)>;
    explicit Puppet(Act act) : act_(std::move(act)) {}

    using Solver::solve;
    solvers::SolveCount solve(const SystemEquation& system, const Island& island,
                              const solvers::Termination& termination, Columns& lambda) override {
        ++calls;
        return act_(system, island, termination, lambda);
    }
    int calls = 0;

  private:
    Act act_;
};

Puppet::Act filling(double force) {
    return [force](const SystemEquation&, const Island& island, const solvers::Termination&, Columns& lambda) {
        for (const RowRun& run : island.runs) lambda.middleRows(run.begin, run.end - run.begin).setConstant(force);
        return solvers::SolveCount{.iterations = 1, .exact = true};
    };
}

// One step's solve of all islands of a frozen problem.
struct Step {
    explicit Step(const Frozen& problem) : frozen(problem), lambda(problem.zero()) {
        islands.find(frozen.system);
        forces.moving.assign(frozen.system.inverse_mass.size(), Vector6::Zero());
        forces.lasting = forces.moving;
        solver.begin(frozen.system.inverse_mass.size(), frozen.system.awake);
    }
    void solve(solvers::Solver& by, Columns* first_guess = nullptr,
               const solvers::Termination& termination = usual) {
        IslandSolver::Bench bench{.solver = &by};
        const std::vector<Body> at_rest(frozen.system.inverse_mass.size());
        SystemEquation system = frozen.system;  // whose b may change
        for (const Island& island : islands.all()) {
            solver.solve(bench, termination, system, at_rest, island, first_guess, lambda, forces);
        }
    }
    double residual() const { return natural_residual(frozen.system, lambda); }
    const IslandSolver::Outcome& outcome() const { return solver.outcome_of(islands.all().front()); }

    const Frozen& frozen;
    Columns lambda;
    Islands islands;
    ConstraintForces forces;
    IslandSolver solver;
};

// A tower that lands, in both columns.
Frozen landing_tower() {
    return tests::tower_problem("tower", 4, 0.2, tests::weight_friction(), tests::single_frame).frozen();
}

double of_no_forces(const Frozen& frozen) {
    return natural_residual(frozen.system, frozen.zero());
}

Columns swept(const Frozen& frozen, int sweeps) {
    return tests::solve("pgs", frozen.system, frozen.zero(), {.iterations = sweeps});
}

}  // namespace

TEST_CASE("a solver that lies changes nothing: the better of its guess and no forces comes out") {
    const Frozen frozen = landing_tower();
    const Columns good = swept(frozen, 50), bad = 30.0 * good;
    REQUIRE(natural_residual(frozen.system, bad) > of_no_forces(frozen));
    for (const Columns& guess : {frozen.zero(), good, bad}) {
        Puppet liar(filling(1e6));
        Step step(frozen);
        step.lambda = guess;
        step.solve(liar);
        CHECK(liar.calls == 1);
        CHECK(step.residual() <= std::min(natural_residual(frozen.system, guess), of_no_forces(frozen)));
        CHECK_FALSE(step.outcome().solved);
        CHECK(step.outcome().method != IslandSolver::Method::exact);
        // The bodies get the forces in lambda.
        std::vector<Vector6> expected;
        for (Eigen::Index column = 0; column < 2; ++column) {
            constraint_forces(frozen.system, step.lambda, column, expected);
            const auto& got = column == 0 ? step.forces.moving : step.forces.lasting;
            for (std::size_t i = 1; i < got.size(); ++i) CHECK((got[i] - expected[i]).norm() < 1e-9);
        }
    }
}

TEST_CASE("what is not a number is a failure, not a small number") {
    const Frozen frozen = landing_tower();
    for (const double wrong : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        Puppet broken(filling(wrong));
        Step step(frozen);
        step.lambda = swept(frozen, 50);
        const double before = step.residual();
        step.solve(broken);
        CHECK(step.lambda.allFinite());
        CHECK(step.residual() <= before);
        CHECK(step.outcome().method != IslandSolver::Method::exact);
    }
    // One NaN of many is enough, and a guess that is NaN too leaves no forces.
    Puppet one_row([](const SystemEquation&, const Island& island, const solvers::Termination&, Columns& lambda) {
        lambda(island.runs.back().begin, 0) = std::numeric_limits<double>::quiet_NaN();
        return solvers::SolveCount{.iterations = 1};
    });
    Step step(frozen);
    step.lambda.setConstant(std::numeric_limits<double>::quiet_NaN());
    step.solve(one_row);
    CHECK(step.lambda.isZero(0.0));
    CHECK(std::isinf(natural_residual(
        frozen.system, Columns::Constant(frozen.system.row_count(), 2, std::numeric_limits<double>::quiet_NaN()))));
}

TEST_CASE("each column is guarded by itself") {
    const Frozen frozen = landing_tower();
    const Columns good = tests::solve("direct", frozen.system, frozen.zero(), {.iterations = 1000});
    Puppet half([&](const SystemEquation&, const Island&, const solvers::Termination&, Columns& lambda) {
        lambda.col(0) = good.col(0);
        lambda.col(1).setConstant(1e6);
        return solvers::SolveCount{.iterations = 1};
    });
    Step step(frozen);
    step.solve(half);
    CHECK(step.lambda.col(0) == good.col(0));
    CHECK(step.lambda.col(1).isZero(0.0));
}

TEST_CASE("a look is at most as bad as what the step began with, too") {
    const Frozen frozen = landing_tower();
    Columns good = swept(frozen, 200);
    Puppet idle(
        [](const auto&, const auto&, const auto&, Columns&) { return solvers::SolveCount{.iterations = 1}; });
    Step step(frozen);
    step.lambda = 0.5 * good;  // the result of the solve before
    REQUIRE(step.residual() > natural_residual(frozen.system, good));
    step.solve(idle, &good);
    CHECK(step.residual() <= natural_residual(frozen.system, good));
}

TEST_CASE("a guess that will do is kept without asking the solver, tolerances of zero take any answer as it is") {
    const Frozen frozen = landing_tower();
    Puppet liar(filling(7.0));
    Step step(frozen);
    step.lambda = tests::solve("direct", frozen.system, frozen.zero(),
                               {.iterations = 1000, .tolerance_high = 1e-12, .tolerance_low = 1e-12});
    const Columns before = step.lambda;
    step.solve(liar);
    CHECK(liar.calls == 0);
    CHECK(step.lambda == before);
    CHECK(step.outcome().solved);

    Step fixed_number(frozen);
    fixed_number.solve(liar, nullptr, {.iterations = 25});
    CHECK(liar.calls == 1);
    CHECK((fixed_number.lambda.array() == 7.0).all());
    CHECK(fixed_number.outcome().solved);
}

TEST_CASE("no solver makes a random problem worse, from any guess") {
    for (const solvers::SolverEntry& entry : solvers::solver_table()) {
        if (entry.name == "dense") continue;  // pgs, at the third power of the price
        const auto solver = entry.make();
        for (std::uint64_t seed = 1; seed <= 40; ++seed) {
            const auto friction = seed % 2 == 0 ? tests::RandomFriction::box : tests::RandomFriction::coulomb;
            const Frozen frozen = tests::random_contacts(seed, friction, 3.0);
            for (const int sweeps : {0, 3, 300}) {
                const Columns guess = swept(frozen, sweeps + 1) * (sweeps == 3 ? 10.0 : 1.0);
                Step step(frozen);
                step.lambda = guess;
                step.solve(*solver);
                INFO(entry.name << ", seed " << seed << ", guess " << sweeps);
                for (const Island& island : step.islands.all()) {
                    const double best = std::min(island_residual(frozen.system, island, guess),
                                                 island_residual(frozen.system, island, frozen.zero()));
                    CHECK(island_residual(frozen.system, island, step.lambda) <= best * (1.0 + 1e-9) + 1e-12);
                }
            }
        }
    }
}

TEST_CASE("an island that was in small steps and is solved again has the forces of its last solution") {
    const tests::Problem tower =
        tests::tower_problem("tower", 4, 0.2, tests::weight_friction(), tests::single_frame);
    const Frozen frozen = tower.frozen();
    Step step(frozen);
    const Island& island = step.islands.all().front();
    SmallSteps small_steps;
    IslandSolver::Bench bench{.small_steps = &small_steps};
    std::vector<Lambda> ending(frozen.rows.size());
    step.solver.take_small_steps(bench, frozen.system, tower.bodies, island, {}, step.lambda, step.forces, ending);
    CHECK(step.outcome().method == IslandSolver::Method::in_small_steps);
    const Columns exact = tests::solve("direct", frozen.system, frozen.zero(), usual);
    Puppet again([&](const SystemEquation&, const Island&, const solvers::Termination&, Columns& lambda) {
        lambda = exact;
        return solvers::SolveCount{.iterations = 1, .exact = true};
    });
    step.solve(again);
    CHECK(again.calls == 1);
    CHECK(step.outcome().method == IslandSolver::Method::exact);
    // What was solved exactly and is kept when it is looked at again still counts as solved exactly.
    step.solve(again);
    CHECK(again.calls == 1);
    CHECK(step.outcome().method == IslandSolver::Method::exact);
}

TEST_CASE("a world with a solver that lies goes on, and says how often it was not solved") {
    for (const double force : {1e9, std::numeric_limits<double>::quiet_NaN()}) {
        const demos::SceneEntry& entry = *demos::find_scene("stack");
        demos::BuiltScene scene = demos::build_scene(entry.describe(demos::ParameterValues(entry.parameters)),
                                                     tests::awake_settings("default"));
        World& world = scene.world;
        world.solver = std::make_unique<Puppet>(filling(force));
        int unsolved = 0;
        for (int step = 0; step < 60; ++step) unsolved += world.step(1.0 / 60.0).islands_unsolved > 0;
        CHECK(unsolved > 20);
        for (const Body& body : world.bodies) CHECK(body.position.allFinite());
        CHECK(kinetic_energy(world.bodies) < 1e4);
    }
}
