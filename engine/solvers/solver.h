// What all solvers have in common, paper sections 6.2.3 and 7: one signature, one table of names.
#pragma once

#include "engine/system/islands.h"
#include "engine/system/system_equation.h"

#include <limits>
#include <memory>
#include <span>
#include <string_view>

namespace pushfactor::engine::solvers {

// When to stop (6.2.3). While the natural-map residual of the guess is at most `tolerance_high` nothing needs to be
// solved, which the caller of a solver finds out; a solver works until the residual is at most `tolerance_low` or
// the iterations are used up. Tolerances of zero give the paper's fixed number of iterations.
//
// Two tolerances because a stack under frozen forces is an inverted pendulum: with a single one it would circle
// at the tolerance for ever instead of coming to rest.
//
// What exact methods may take is counted in multiply-adds and over all solves of a step (budget.h).
struct Termination {
    int iterations = 25;          // 0: only what a method gives that goes to rounding
    double tolerance_high = 0.0;  // m/s
    double tolerance_low = 0.0;   // m/s, at most tolerance_high, but after an exact answer (warm_start.h)
    double credit = std::numeric_limits<double>::infinity();  // that they may spend where they have to pay off
    double spent = 0.0;                                       // that they have spent on these bodies in this step
    bool lasts = false;                                       // whether an exact answer may serve for many steps
};

// What a solve took.
struct SolveCount {
    int iterations = 0;           // of the solver's own kind
    double multiply_adds = 0.0;   // work, the same on every machine; loading and storing are left out
    bool exact = false;           // whether it was solved to the tolerance by a method that goes to rounding
    double exact_work = 0.0;      // multiply-adds, the share of such methods
    int exact_iterations = 0;     // their share of the iterations
    bool gave_up = false;         // whether such a method was tried and did not get there
    bool exhausted = false;       // whether more iterations would be of no use
    bool contradicts = false;     // whether it found rows that no forces can satisfy together
    bool in_small_steps = false;  // whether the step was taken in small ones (small_steps.h)
};

class Solver {
  public:
    virtual ~Solver() = default;

    // Solves the rows of `island`, which is one of `system`, in all its columns. `lambda` [N, rows of the system x
    // its columns] holds the guess and receives the answer, in both columns when the island has one; rows of other
    // islands are neither read nor written. A row with A_jj = 0 gets lambda 0.
    virtual SolveCount solve(const SystemEquation& system, const Island& island, const Termination& termination,
                             Columns& lambda) = 0;

    // One that does the same, for another thread to solve other islands at the same time; null: there is none, and
    // islands are solved one after the other.
    virtual std::unique_ptr<Solver> another() const { return nullptr; }

    // Solves `system` island by island, but for those whose guess will do. Counts the most iterations of an island
    // and the work of all of them.
    SolveCount solve(const SystemEquation& system, const Termination& termination, Columns& lambda);
};

struct SolverEntry {
    std::string_view name;
    std::string_view description;
    std::unique_ptr<Solver> (*make)();
};

// Every solver that there is, by the name that the command line uses.
std::span<const SolverEntry> solver_table();

// Throws InvalidInput when no solver has that name.
std::unique_ptr<Solver> make_solver(std::string_view name);

}  // namespace pushfactor::engine::solvers
