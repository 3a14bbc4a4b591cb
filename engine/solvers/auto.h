#pragma once

#include "engine/solvers/solver.h"

namespace pushfactor::engine::solvers {

// Pairs per movable body up to which bodies are connected like a thread, static partners included: 1 for one that
// hangs or stands, 1.5 for the pendulum grid, for which the exact answer costs no more than 25 sweeps, and about 3
// for a heap.
inline constexpr double pairs_of_a_thread = 1.5;

// Sweeps or the exact answer, whichever pays for the bodies as they are connected; see auto.cpp.
std::unique_ptr<Solver> make_auto();

}  // namespace pushfactor::engine::solvers
