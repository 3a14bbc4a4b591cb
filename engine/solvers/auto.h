#pragma once

#include "engine/solvers/solver.h"

namespace pushfactor::engine::solvers {

// Sweeps or the exact answer, whichever pays for the bodies as they are connected; see auto.cpp.
std::unique_ptr<Solver> make_auto();

}  // namespace pushfactor::engine::solvers
