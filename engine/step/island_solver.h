// Solves one island in a step: whether its last forces are good enough (warm_start.h), the budget for better ones
// (budget.h), and a guard around the solver. For any solver the result is at most as bad as the best of the
// previous forces and of zero forces, per column, by the natural-map residual; NaN counts as worse than anything.
//
// With tolerances of zero (the paper's fixed number of iterations) the result is taken as it is.
#pragma once

#include "engine/base/threads.h"
#include "engine/solvers/solver.h"
#include "engine/step/budget.h"
#include "engine/step/small_steps.h"
#include "engine/step/warm_start.h"
#include "engine/system/islands.h"

#include <array>
#include <span>
#include <vector>

namespace pushfactor::engine {

class IslandSolver {
  public:
    // State per body that is carried to the next step.
    struct Memory {
        WarmStart::Memory forces;
        Budget::Debt debt;
    };

    // Result of the last solve of an island in the step.
    using Residuals = std::array<double, 2>;  // m/s, of both columns; 0 for a missing second one
    struct Outcome {
        bool solved = true;           // residual within the tolerance; true if there is none
        bool refused = false;         // the guard has replaced the solver's forces
        bool contradicts = false;     // the solver found rows that no forces can satisfy together
        bool outdated = false;        // a new force made kept forces wrong
        bool unfinished = false;      // only exact solves were allowed, and they failed
        bool in_small_steps = false;  // the step was divided into small ones
        bool exhausted = false;       // more iterations would not help
        Residuals residuals{};        // of the current forces
        Budget::Outlook outlook = Budget::Outlook::moving;
    };

    // Limits of a solve: its share of the remaining iterations. If the residual of the warm start exceeds
    // `iterates_up_to` [m/s], only an exact solve is tried, and the island may be left unfinished.
    struct Allowed {
        Budget::Take take = Budget::Take::half;
        double iterates_up_to = infinity;
        double stands_up_to = 0.0;  // m/s; warm start's residual up to which an exact solution may last; 0: never
    };

    // Tools and scratch memory of one thread.
    struct Bench {
        solvers::Solver* solver = nullptr;
        SmallSteps* small_steps = nullptr;  // null: none are taken
        Threads* threads = nullptr;         // share the work on the island; null: one thread
        RunsOfBodies runs_of{};             // of the island, if there are threads
        std::vector<double> saved{};        // lambda of the island before the solve
        std::vector<Vector6> velocities{};  // scratch for residuals, by body of the island
    };

    // To be called before the first solve of a step; `awake` are the bodies that take part, out of `bodies`.
    void begin(std::size_t bodies, std::span<const int> awake);

    // Reverts a step that is started again because it met a resting body.
    void take_back(std::span<const int> awake) { budget_.take_back(awake); }

    // To be called before a step with other awake bodies than the last one.
    void forget_islands() { warm_start_.forget_islands(); }

    // To be called between solves that are separate problems and are budgeted separately.
    void begin_another() { budget_.begin_another(); }

    // Different islands may be solved concurrently, with one bench per thread.
    //
    // Solves `island`, with the forces in `lambda` as warm start, which receives the solution; writes f_c of its
    // bodies. A re-solve within a step, because of additional rows, passes the warm start of the first solve as
    // `first_guess`, which may be clamped to its bounds.
    solvers::SolveCount solve(Bench& bench, const solvers::Termination& usual, const SystemEquation& system,
                              const Island& island, const Allowed& allowed, Columns* first_guess, Columns& lambda,
                              ConstraintForces& forces);

    // Divides the step of an unfinished island into small steps. Writes the warm start of the next step into
    // `ending` (by row of the step) [N].
    solvers::SolveCount take_small_steps(Bench& bench, const SystemEquation& system, std::span<const Body> bodies,
                                         const Island& island, Columns& lambda, ConstraintForces& forces,
                                         std::span<Lambda> ending);

    // Continues a solve in this step; the island's rows must be unchanged.
    solvers::SolveCount go_on(Bench& bench, const solvers::Termination& usual, const SystemEquation& system,
                              const Island& island, Columns& lambda, ConstraintForces& forces);

    // Whether the last solve of `island` in this step left it unsolved and more iterations may help.
    bool can_go_on(const Island& island, const solvers::Termination& usual) const {
        const Outcome& outcome = outcome_of(island);
        return !outcome.solved && !outcome.exhausted && budget_.iterations_left(island, usual) > 0;
    }

    const Outcome& outcome_of(const Island& island) const {
        return outcomes_[static_cast<std::size_t>(island.bodies.front())];
    }
    const WarmStart& warm_start() const { return warm_start_; }

    // To be called after the last solve of a step and after the last use of warm_start().
    void end(std::span<const int> awake) { warm_start_.end(awake); }

    void take_memory(std::vector<Memory>& memory) const;  // by body; empty before the first step
    void set_memory(std::span<const Memory> memory);

  private:
    static void find_forces(const SystemEquation& system, const Island& island, const Columns& lambda,
                            ConstraintForces& forces, const Bench& bench);
    static Residuals measure(const SystemEquation& system, const Island& island, const Columns& lambda,
                             ConstraintForces& forces, Bench& bench);
    bool is_outdated(const SystemEquation& system, const Island& island, const Columns& lambda,
                     const solvers::Termination& usual, const Bench& bench) const;
    Budget::Outlook outlook_of(const Island& island, double residual, const Allowed& allowed,
                               const Columns& lambda) const;
    Residuals of_no_forces(const SystemEquation& system, const Island& island) const;
    static void save(const Island& island, const Columns& lambda, Bench& bench);
    solvers::SolveCount find_better(Bench& bench, const solvers::Termination& termination,
                                    const SystemEquation& system, const Island& island, Columns* first_guess,
                                    Columns& lambda, ConstraintForces& forces, Outcome& outcome);
    bool guard(const SystemEquation& system, const Island& island, const Residuals& guessed, Columns* first_guess,
               Columns& lambda, ConstraintForces& forces, Bench& bench, Residuals& found);
    void note(const Island& island, const Outcome& outcome, const solvers::SolveCount& count);

    WarmStart warm_start_;
    Budget budget_;
    std::vector<Outcome> outcomes_;  // by body, of its island
};

}  // namespace pushfactor::engine
