#pragma once

#include "engine/solvers/solver.h"

namespace pushfactor::engine::solvers {

// Pairs per movable body of an island up to which its bodies are connected like a thread, static partners included:
// 1 for one that hangs or stands, 1.6 and more where a body of the pendulum grid lies on others, about 3 for a
// heap.
inline constexpr double pairs_of_a_thread = 1.5;

// Sweeps or the exact answer, whichever pays for the bodies as they are connected; see auto.cpp.
std::unique_ptr<Solver> make_auto();

}  // namespace pushfactor::engine::solvers
