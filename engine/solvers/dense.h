// Projected Gauss-Seidel as paper section 7.2 prints it, on the dense matrix A = J M^-1 J^T.
// Cubic in the number of rows: an oracle for the sparse sweep, not a product.
#pragma once

#include "engine/solvers/solver.h"

#include <memory>

namespace pushfactor::engine::solvers {

std::unique_ptr<Solver> make_dense();

}  // namespace pushfactor::engine::solvers
