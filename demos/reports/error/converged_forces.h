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

// The converged forces of at most 1e-10 m/s (natural map), starting from `guess`. None if no solver converges.
std::optional<engine::Columns> converged_forces(const engine::SystemEquation& system, const engine::Columns& guess);

}  // namespace pushfactor::demos::reports::error
