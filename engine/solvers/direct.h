#pragma once

#include "engine/solvers/solver.h"

namespace pushfactor::engine::solvers {

// Exact solver, see direct.cpp. `Termination::iterations` bounds the factorisations per column, and the sweeps if
// it fails.
std::unique_ptr<Solver> make_direct();

}  // namespace pushfactor::engine::solvers
