// Interface of all solvers, paper sections 6.2.3 and 7, and the table of their names.
#pragma once

#include "engine/system/islands.h"
#include "engine/system/system_equation.h"

#include <algorithm>
#include <memory>
#include <span>
#include <string_view>

namespace pushfactor::engine::solvers {

// What an exact solution of an island may cost in multiply-adds per column, including what is solved again: a
// second or less.
inline constexpr double most_exact_work = 4e9;

// When to stop (6.2.3). If the natural-map residual of the warm start is at most `tolerance_high` no solve is
// needed, which the caller of a solver checks; a solver iterates until the residual is at most `tolerance_low` or
// the iterations are used up. Tolerances of zero give the paper's fixed number of iterations.
//
// There are two tolerances because a stack under frozen forces is an inverted pendulum: with a single one it would
// cycle at the tolerance instead of coming to rest.
struct Termination {
    int iterations = 25;          // per solve, at most; 0: only exact methods
    double tolerance_high = 0.0;  // m/s
    double tolerance_low = 0.0;   // m/s, at most tolerance_high
    // For a solver that has other ways: what an exact solution is worth in multiply-adds, how many factorisations
    // it is expected to take and may take in any case once it is begun, and the residual [m/s] up to which it is
    // better than what would be done instead.
    double worth = most_exact_work;
    double factorisations = 1.0, at_least = 0.0;
    double will_do = 0.0;
};

// Result and cost of a solve.
struct SolveCount {
    int iterations = 0;          // of the solver's own kind, of the column with the most of them
    double row_updates = 0.0;    // 0: in each iteration every row in every column
    double multiply_adds = 0.0;  // work, machine-independent; without loading and storing
    bool exact = false;          // solved by an exact method
    bool contradicts = false;    // it found rows that no forces can satisfy together

    // Adds another column or island.
    void add(const SolveCount& other) {
        iterations = std::max(iterations, other.iterations);
        row_updates += other.row_updates;
        multiply_adds += other.multiply_adds;
        exact = exact && other.exact;
        contradicts = contradicts || other.contradicts;
    }
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
