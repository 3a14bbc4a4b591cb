// Interface of all solvers, paper sections 6.2.3 and 7, and the table of their names.
#pragma once

#include "engine/system/islands.h"
#include "engine/system/system_equation.h"

#include <memory>
#include <span>
#include <string_view>

namespace pushfactor::engine::solvers {

// When to stop (6.2.3). If the natural-map residual of the warm start is at most `tolerance_high` no solve is
// needed, which the caller of a solver checks; a solver iterates until the residual is at most `tolerance_low` or
// the iterations are used up. Tolerances of zero give the paper's fixed number of iterations.
//
// There are two tolerances because a stack under frozen forces is an inverted pendulum: with a single one it would
// cycle at the tolerance instead of coming to rest.
//
// The work of exact methods is limited in multiply-adds, over all solves of a step (budget.h).
struct Termination {
    int iterations = 25;          // 0: only exact methods
    double tolerance_high = 0.0;  // m/s
    double tolerance_low = 0.0;   // m/s, at most tolerance_high, except after an exact solve (warm_start.h)
    double credit = infinity;     // multiply-adds, if exact methods have to pay off
    double spent = 0.0;           // multiply-adds spent on these bodies in this step
    bool lasts = false;           // an exact solution may serve for many steps
};

// Result and cost of a solve.
struct SolveCount {
    int iterations = 0;           // of the solver's own kind
    double multiply_adds = 0.0;   // work, machine-independent; without loading and storing
    bool exact = false;           // solved to the tolerance by an exact method
    double exact_work = 0.0;      // multiply-adds of exact methods
    int exact_iterations = 0;     // iterations of exact methods
    bool gave_up = false;         // an exact method was tried and failed
    bool exhausted = false;       // more iterations would not help
    bool contradicts = false;     // it found rows that no forces can satisfy together
    bool in_small_steps = false;  // the step was divided into small ones (small_steps.h)
};

class Solver {
  public:
    virtual ~Solver() = default;

    // Solves the rows of `island`, one of `system`, in all its columns. `lambda` [N, rows of the system x its
    // columns] holds the warm start and receives the solution, in both columns if the island has one; rows of other
    // islands are neither read nor written. A row with A_jj = 0 gets lambda 0.
    virtual SolveCount solve(const SystemEquation& system, const Island& island, const Termination& termination,
                             Columns& lambda) = 0;

    // Another instance for solving other islands concurrently; null: none, and islands are solved one after the
    // other.
    virtual std::unique_ptr<Solver> another() const { return nullptr; }

    // Solves `system` island by island, except those whose warm start is good enough. Returns the maximum of the
    // islands' iterations and the sum of their work.
    SolveCount solve(const SystemEquation& system, const Termination& termination, Columns& lambda);
};

struct SolverEntry {
    std::string_view name;
    std::string_view description;
    std::unique_ptr<Solver> (*make)();
};

// All solvers, by the name used on the command line.
std::span<const SolverEntry> solver_table();

// Throws InvalidInput for an unknown name.
std::unique_ptr<Solver> make_solver(std::string_view name);

}  // namespace pushfactor::engine::solvers
