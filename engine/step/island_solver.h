// Solves one island in a step: keeps its guess if that is good enough, else finds better forces directly, in small
// steps or by sweeps (choice.h), and guards the result. For any solver it is at most as bad as the best of the
// guess and of zero forces, per column, by the natural-map residual; NaN counts as worse than anything.
//
// With tolerances of zero (the paper's fixed number of iterations) the result is taken as it is.
#pragma once

#include "engine/base/threads.h"
#include "engine/solvers/solver.h"
#include "engine/step/small_steps.h"
#include "engine/system/islands.h"

#include <array>
#include <span>
#include <vector>

namespace pushfactor::engine {

class IslandSolver {
  public:
    // How an island was treated, in ascending order of what counts if it was solved several times.
    enum class Method { kept, swept, exact, in_small_steps };

    // Result of the solves of an island in the step.
    using Residuals = std::array<double, 2>;  // m/s, of both columns; 0 for a missing second one
    struct Outcome {
        Method method = Method::kept;
        bool solved = true;        // residual within the tolerance; true if there is none
        bool contradicts = false;  // the solver found rows that no forces can satisfy together
        bool unfinished = false;   // left to small steps
        Residuals residuals{};     // of the current forces
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

    // Different islands may be solved concurrently, with one bench per thread.
    //
    // Solves `island`, with the forces in `lambda` as warm start, which receives the solution; writes f_c of its
    // bodies. A re-solve within a step, because of additional rows, passes the warm start of the first solve as
    // `first_guess`, which may be clamped to its bounds. With small steps the island may be left unfinished.
    solvers::SolveCount solve(Bench& bench, const solvers::Termination& usual, SystemEquation& system,
                              std::span<const Body> bodies, const Island& island, Columns* first_guess,
                              Columns& lambda, ConstraintForces& forces);

    // Takes the step of an unfinished island in small steps. Writes the warm start of the next step into `ending`
    // (by row of the step) [N].
    solvers::SolveCount take_small_steps(Bench& bench, const SystemEquation& system, std::span<const Body> bodies,
                                         const Island& island, const RowSources& sources, Columns& lambda,
                                         ConstraintForces& forces, std::span<Lambda> ending);

    const Outcome& outcome_of(const Island& island) const {
        return outcomes_[static_cast<std::size_t>(island.bodies.front())];
    }

  private:
    static void find_forces(const SystemEquation& system, const Island& island, const Columns& lambda,
                            ConstraintForces& forces, const Bench& bench);
    static Residuals measure(const SystemEquation& system, const Island& island, const Columns& lambda,
                             ConstraintForces& forces, Bench& bench);
    Residuals of_no_forces(const SystemEquation& system, const Island& island) const;
    static void save(const Island& island, const Columns& lambda, Bench& bench);
    solvers::SolveCount find_better(Bench& bench, const solvers::Termination& termination,
                                    const SystemEquation& system, const Island& island, Columns* first_guess,
                                    Columns& lambda, ConstraintForces& forces, Outcome& outcome);
    void lessen(Bench& bench, const solvers::Termination& termination, SystemEquation& system, const Island& island,
                Columns& lambda, ConstraintForces& forces, Outcome& outcome, solvers::SolveCount& count);
    bool guard(const SystemEquation& system, const Island& island, const Residuals& guessed, Columns* first_guess,
               Columns& lambda, ConstraintForces& forces, Bench& bench, Residuals& found);
    void note(const Island& island, Outcome outcome);

    std::vector<Outcome> outcomes_;  // by body, of its island
};

}  // namespace pushfactor::engine
