// Projected Gauss-Seidel on the sparse rows (paper section 7): A is never formed, and the cost per row does not
// depend on the number of rows. `dense` is its test oracle.
#pragma once

#include "engine/solvers/solver.h"

#include <memory>

namespace pushfactor::engine::solvers {

std::unique_ptr<Solver> make_pgs();

}  // namespace pushfactor::engine::solvers
