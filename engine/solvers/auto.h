#pragma once

#include "engine/solvers/solver.h"

namespace pushfactor::engine::solvers {

// Pairs per movable body, static partners included, up to which an island counts as a chain: 1 for a hanging or
// standing body, 1.6 and more where a body of the pendulum grid lies on others, about 3 for a heap.
inline constexpr double pairs_of_a_thread = 1.5;

// Sweeps or exact solves, per island by its connectivity and cost; see auto.cpp.
std::unique_ptr<Solver> make_auto();

}  // namespace pushfactor::engine::solvers
