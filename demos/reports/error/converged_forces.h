// Reference forces: the same system solved down to a negligible residual.
//
//   e_f = sqrt( (lambda - lambda*)^T A (lambda - lambda*) / (lambda*^T A lambda*) )
//
// the relative error of the accelerations that the constraint forces give. Box on box has more contacts than
// unknown reactions, so lambda* is not unique; A lambda* is, and e_f sees nothing else.
//
// Symbols: A = J M^-1 J^T [1/kg], lambda answer and lambda* converged answer [N], e_f [1].
#pragma once

#include "engine/solvers/solver.h"

#include <optional>

namespace pushfactor::demos::reports::error {

// e_f, the largest over the columns. None if the converged forces are zero.
std::optional<double> force_error(const engine::SystemEquation& system, const engine::Columns& lambda,
                                  const engine::Columns& converged);

class ConvergedSolver {
  public:
    static constexpr double residual = 1e-10;  // m/s, natural map: bound of convergence

    ConvergedSolver();

    // The converged forces, starting from `guess`. None if no solver converges.
    std::optional<engine::Columns> solve(const engine::SystemEquation& system, const engine::Columns& guess);

  private:
    std::unique_ptr<engine::solvers::Solver> direct_;  // null if this build has none
    std::unique_ptr<engine::solvers::Solver> experiments_;
};

}  // namespace pushfactor::demos::reports::error
