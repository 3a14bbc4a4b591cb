// Rows that close a loop of joints, bars and contacts: they may be redundant, and after a finite rotation they
// disagree slightly. The forces that enforce all of them are huge and move nothing, or jam what rubs.
//
// So such rows are soft, s = 1e-4 j_c M^-1 j_c^T, and what that gives way to is taken out of their targets
// (IslandSolver::lessen), which leaves the forces of least norm, with rows in units of their own mobility.
//
// Not from the paper.
#pragma once

#include "engine/constraints/constraint_row.h"
#include "engine/constraints/point_jacobian.h"

namespace pushfactor::engine {

// Sets the softness of a rigid row that closes a loop.
void soften(const BodyPair& bodies, ConstraintRow& row);

// Whether the row is rigid but for that.
bool is_of_loop(const ConstraintRow& row);

}  // namespace pushfactor::engine
