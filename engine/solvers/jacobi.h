// The Jacobi method mentioned in paper sections 6.2.3 and 7.1 beside Gauss-Seidel: every row from the state of the
// last iteration. For comparison only. As printed it leaves a stack with a larger error than no forces at all,
// because rows that share a body all correct the same error at once; here it is relaxed (jacobi.cpp), which is slow
// everywhere and still does not converge where many rows meet in a body.
#pragma once

#include "engine/solvers/solver.h"

#include <memory>

namespace pushfactor::engine::solvers {

// Under-relaxation factor.
inline constexpr double jacobi_weight = 0.3;

std::unique_ptr<Solver> make_jacobi();

}  // namespace pushfactor::engine::solvers
