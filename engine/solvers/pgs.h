// Projected Gauss-Seidel on the sparse rows (paper section 7): A is never formed, a row costs the same however
// many others there are. The product; `dense` is its oracle.
#pragma once

#include "engine/solvers/solver.h"

#include <memory>

namespace pushfactor::engine::solvers {

std::unique_ptr<Solver> make_pgs();

}  // namespace pushfactor::engine::solvers
