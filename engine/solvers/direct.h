#pragma once

#include "engine/solvers/solver.h"

namespace pushfactor::engine::solvers {

// The exact answer, see direct.cpp. `Termination::iterations` is the largest number of factorisations a column.
std::unique_ptr<Solver> make_direct();

}  // namespace pushfactor::engine::solvers
