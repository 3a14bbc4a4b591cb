// The solve of one island in a step: whether its last forces will do (warm_start.h), what finding better ones may
// cost (budget.h), and the guard around the solver. Whatever a solver does, what comes out is at most as bad as the
// best of what the rows had before and of no forces at all, column by column, by the natural-map residual; a
// residual that is not a number is worse than any.
//
// With tolerances of zero (the paper's fixed number of iterations) the answer is taken as it is.
#pragma once

#include "engine/base/threads.h"
#include "engine/solvers/solver.h"
#include "engine/step/budget.h"
#include "engine/step/small_steps.h"
#include "engine/step/warm_start.h"
#include "engine/system/islands.h"

#include <array>
#include <limits>
#include <span>
#include <vector>

namespace pushfactor::engine {

class IslandSolver {
  public:
    // What a step leaves to the next, of one body.
    struct Memory {
        WarmStart::Memory forces;
        Budget::Debt debt;
    };

    // What became of an island in its last solve of the step.
    using Residuals = std::array<double, 2>;  // m/s, of both columns; 0 of a second one that there is not
    struct Outcome {
        bool solved = true;           // whether that is within the tolerance; true where there is none
        bool refused = false;         // whether the guard took other forces than those of the solver
        bool contradicts = false;     // whether the solver found rows that no forces can satisfy together
        bool outdated = false;        // whether a new force made kept forces wrong
        bool unfinished = false;      // whether exact answers alone were asked for, and there is none
        bool in_small_steps = false;  // whether it has gone through the step in small ones
        bool exhausted = false;       // whether more iterations would be of no use
        Residuals residuals{};        // of the forces as they are
        Budget::Outlook outlook = Budget::Outlook::moving;
    };

    // What a solve may do: which iterations of those that are left. Of a guess with a residual of more than
    // `iterates_up_to` [m/s], it looks for an exact answer only, and may leave the island unfinished.
    struct Allowed {
        Budget::Take take = Budget::Take::half;
        double iterates_up_to = std::numeric_limits<double>::infinity();
        double stands_up_to = 0.0;  // m/s; residual of a guess that an exact answer may serve for good, if any
    };

    // What one thread solves with, one island after the other.
    struct Bench {
        solvers::Solver* solver = nullptr;
        SmallSteps* small_steps = nullptr;  // null: none are taken
        Threads* threads = nullptr;         // that share the work on the island; null: one thread
        RunsOfBodies runs_of{};             // with threads: of the island
        std::vector<double> saved{};        // lambda of the island before it was solved
        std::vector<Vector6> velocities{};  // of its bodies, while it is measured
    };

    // Before the first solve of a step in which those `awake` of all bodies take part.
    void begin(std::size_t bodies, std::span<const int> awake);

    // Forgets a step that was begun with the same, in which one at rest was met.
    void take_back(std::span<const int> awake) { budget_.take_back(awake); }

    // Before a step in which others take part than in the last one.
    void forget_islands() { warm_start_.forget_islands(); }

    // Between solves that are problems of their own, whose work does not count together.
    void begin_another() { budget_.begin_another(); }

    // The solves of different islands, with a bench each, may go on at the same time.
    //
    // Solves `island` from the forces in `lambda`, which receives the answer; writes f_c of its bodies. A solve
    // beyond the first one of a step, because of more rows, passes as `first_guess` what that one began with, and
    // may find it put within its bounds.
    solvers::SolveCount solve(Bench& bench, const solvers::Termination& usual, const SystemEquation& system,
                              const Island& island, const Allowed& allowed, Columns* first_guess, Columns& lambda,
                              ConstraintForces& forces);

    // Takes an island that is unfinished through the step in small ones. Writes into `ending` (by row of the step)
    // what the next step begins with [N].
    solvers::SolveCount take_small_steps(Bench& bench, const SystemEquation& system, std::span<const Body> bodies,
                                         const Island& island, Columns& lambda, ConstraintForces& forces,
                                         std::span<Lambda> ending);

    // The same for an island that was solved in this step and has the same rows still.
    solvers::SolveCount go_on(Bench& bench, const solvers::Termination& usual, const SystemEquation& system,
                              const Island& island, Columns& lambda, ConstraintForces& forces);

    // Whether the last solve of `island` in this step has left it unsolved, and iterations that may help.
    bool can_go_on(const Island& island, const solvers::Termination& usual) const {
        const Outcome& outcome = outcome_of(island);
        return !outcome.solved && !outcome.exhausted && budget_.iterations_left(island, usual) > 0;
    }

    const Outcome& outcome_of(const Island& island) const {
        return outcomes_[static_cast<std::size_t>(island.bodies.front())];
    }
    const WarmStart& warm_start() const { return warm_start_; }

    // After the last solve of a step and what warm_start() has to say about its forces.
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
