#pragma once

#include "engine/solvers/solver.h"

namespace pushfactor::engine::solvers {

// An exact solver where that is worth its cost, else sweeps, per island; see direct.cpp.
std::unique_ptr<Solver> make_auto();

// The same up to `most_exact_work`. `Termination::iterations` bounds the factorisations per column, and the sweeps
// if it fails.
std::unique_ptr<Solver> make_direct();

}  // namespace pushfactor::engine::solvers
