#include "engine/solvers/solver.h"

#include "engine/base/invalid_input.h"
#include "engine/solvers/dense.h"
#include "engine/solvers/direct.h"
#include "engine/solvers/jacobi.h"
#include "engine/solvers/nncg.h"
#include "engine/solvers/pgs.h"

#include <array>
#include <string>

namespace pushfactor::engine::solvers {

SolveCount Solver::solve(const SystemEquation& system, const Termination& termination, Columns& lambda) {
    Islands islands;
    islands.find(system);
    if (!islands.hold_all_rows()) {
        for (Eigen::Index j = 0; j < system.row_count(); ++j) {
            if (!(system.diagonal[j] > 0.0)) lambda.row(j).setZero();
        }
    }
    SolveCount all{.exact = !islands.all().empty()};
    for (const Island& island : islands.all()) {
        const bool checked = termination.tolerance_high > 0.0;
        if (checked && island_residual(system, island, lambda) <= termination.tolerance_high) continue;
        all.add(solve(system, island, termination, lambda));
    }
    return all;
}

std::span<const SolverEntry> solver_table() {
    static constexpr std::array table{
        SolverEntry{"auto", "the exact answer where bodies are connected like a thread, else sweeps", make_auto},
        SolverEntry{"pgs", "projected Gauss-Seidel on the sparse rows", make_pgs},
        SolverEntry{"direct", "the exact answer, by Newton steps in the space of the bodies", make_direct},
        SolverEntry{"dense", "projected Gauss-Seidel on the dense A, as section 7.2 prints it", make_dense},
        SolverEntry{"jacobi", "relaxed Jacobi: every row from the last iteration; for comparison", make_jacobi},
        SolverEntry{"nncg", "nonsmooth nonlinear conjugate gradients, built from sweeps", make_nncg},
    };
    return table;
}

std::unique_ptr<Solver> make_solver(std::string_view name) {
    std::string names;
    for (const SolverEntry& entry : solver_table()) {
        if (entry.name == name) return entry.make();
        names += (names.empty() ? "" : ", ") + std::string(entry.name);
    }
    throw InvalidInput("solver", std::string(name), "one of " + names);
}

}  // namespace pushfactor::engine::solvers
