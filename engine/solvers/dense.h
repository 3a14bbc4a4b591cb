// Projected Gauss-Seidel as printed in paper section 7.2, on the dense matrix A = J M^-1 J^T. Cubic in the number
// of rows: a test oracle for the sparse sweep.
#pragma once

#include "engine/solvers/solver.h"

#include <memory>

namespace pushfactor::engine::solvers {

std::unique_ptr<Solver> make_dense();

}  // namespace pushfactor::engine::solvers
