// Solves the system equation of a step (paper section 7) island by island: from the warm start of the rows, again
// for islands that get more rows within the step, and what the next step starts with (6.2.3).
#pragma once

#include "engine/constraints/constraint_source.h"
#include "engine/solvers/solver.h"
#include "engine/step/benches.h"
#include "engine/step/island_solver.h"
#include "engine/step/small_steps.h"
#include "engine/step/step_count.h"
#include "engine/system/islands.h"
#include "engine/system/system_equation.h"

#include <cstddef>
#include <span>
#include <vector>

namespace pushfactor::engine {

// What is solved in a step, and with what.
struct StepProblem {
    std::span<const Body> bodies;       // with the external forces
    SystemEquation& system;             // targets of joints in loops are lowered to what they reach
    solvers::Solver* solver = nullptr;  // null only without rows
    const solvers::Termination& termination;
    SmallSteps* small_steps = nullptr;  // null: solver iterations instead
    Threads* threads = nullptr;         // null: one thread
    RowSources sources{};               // of the rows, for small steps
};

class StepSolver {
  public:
    // Finds the islands of a new step, and the warm start of all rows.
    void begin(const StepProblem& problem);

    // Begins, and solves all islands.
    SolveWork solve(const StepProblem& problem);
    // Solves islands with new rows again: these rows, from `first_new` on, start from their warm start, the others
    // from the current solution.
    SolveWork solve_again(const StepProblem& problem, std::size_t first_new);
    // Solves the islands of these numbers as problems of their own, e.g. for another right-hand side. `lambda`
    // holds the warm start and receives the solution.
    SolveWork solve_separately(const StepProblem& problem, std::span<const int> numbers, Columns& lambda);

    // Ends the step. Returns the forces to start the next one with, by row.
    std::span<const Lambda> end(const StepProblem& problem);

    // To be called before a step with other awake bodies than the last one, by those that `changed`. To code that
    // predicts their motion the others are held.
    void leave_out_others(std::span<const Body> bodies, const Awake& awake, std::span<const int> changed);

    // Solution of the last step.
    Columns& lambda() { return lambda_; }
    const Columns& lambda() const { return lambda_; }
    const Islands& islands() const { return islands_; }
    const ConstraintForces& forces() const { return forces_; }
    // Which bodies have got other forces in the last solve, one per body.
    std::span<const char> changed() const { return changed_; }

    // In an island with one column, the forces that move its bodies are the lasting ones.
    bool has_lasting_force(std::size_t body) const {
        const int island = islands_.of_body(static_cast<int>(body));
        if (island < 0) return false;
        const Island& of_body = islands_.all()[static_cast<std::size_t>(island)];
        return of_body.columns == 2 || outcome_of(of_body).method == IslandSolver::Method::in_small_steps;
    }

    // What sets the momenta of a body.
    const Vector6& lasting_force(std::size_t body) const {
        return (has_lasting_force(body) ? forces_.lasting : forces_.moving)[body];
    }

    // How an island was solved.
    const IslandSolver::Outcome& outcome_of(const Island& island) const {
        return island_solver_.outcome_of(island);
    }
    // Natural-map residual of all islands [m/s]. For an island in small steps that of the last small step: the gaps
    // of a whole step are no measure for it.
    double residual(const SystemEquation& system, const solvers::Termination& termination) const;

    // Of the last step, whose solves were `work`; all but the bodies at rest.
    StepCount count(const SystemEquation& system, const SolveWork& work) const;

  private:
    // Writes the warm start of the rows from `first_row` on.
    void guess(const StepProblem& problem, std::size_t first_row, Columns& lambda) const;
    // Selects the islands that satisfy `predicate`, whose bodies get new forces.
    template <typename Predicate>
    void choose(const Predicate& predicate, std::size_t bodies);
    // Calls `solve(island, bench)` for each selected island.
    template <typename Solve>
    SolveWork solve_chosen(const StepProblem& problem, const Solve& solve);
    SolveWork solve(const StepProblem& problem, const Island& island, Columns* first_guess,
                    IslandSolver::Bench& bench);
    void note_changed(const Island& island);
    void find_next_guesses(const Island& island, const RowRun& run);

    Islands islands_;
    IslandSolver island_solver_;
    Benches benches_;
    std::vector<int> chosen_;  // islands to be solved, by number
    Columns lambda_, first_guess_;
    ConstraintForces forces_;
    std::vector<char> changed_;
    std::vector<Lambda> answers_;  // warm start of the next step, one per row
    std::vector<Lambda> endings_;  // of rows of islands in small steps, forces of the last small step
};

}  // namespace pushfactor::engine
