// What all solvers have in common, paper sections 6.2.3 and 7: one signature, one table of names.
#pragma once

#include "engine/islands.h"
#include "engine/system_equation.h"

#include <memory>
#include <span>
#include <string_view>

namespace pushfactor::engine::solvers {

// When to stop (6.2.3). The guess is checked first: while its natural-map residual is at most `tolerance_high`
// nothing is solved; otherwise the solver works until the residual is at most `tolerance_low` or the iterations
// are used up. Tolerances of zero give the paper's fixed number of iterations.
//
// Two tolerances because a stack under frozen forces is an inverted pendulum: with a single one it would circle
// at the tolerance for ever instead of coming to rest.
struct Termination {
    int iterations = 25;          // 1 or more
    double tolerance_high = 0.0;  // m/s
    double tolerance_low = 0.0;   // m/s, at most tolerance_high
};

// What a solve took.
struct SolveCount {
    int iterations = 0;          // of the solver's own kind; 0 when the guess was kept
    double multiply_adds = 0.0;  // work, the same on every machine; loading and storing are left out
    bool exact = false;          // whether it was solved by a method that goes to rounding
    double residual = 0.0;       // m/s, what such a method has left; where rows contradict each other it is large
};

class Solver {
  public:
    virtual ~Solver() = default;

    // Solves the rows of `island`, which is one of `system`, in all its columns. `lambda` [N, rows of the system x
    // its columns] holds the guess and receives the answer, in both columns when the island has one; rows of other
    // islands are neither read nor written. A row with A_jj = 0 gets lambda 0.
    virtual SolveCount solve(const SystemEquation& system, const Island& island, const Termination& termination,
                             Columns& lambda) = 0;

    // Solves `system` island by island. Counts the most iterations of an island and the work of all of them.
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
