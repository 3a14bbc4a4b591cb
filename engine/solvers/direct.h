#pragma once

#include "engine/solvers/solver.h"

namespace pushfactor::engine::solvers {

// Largest cost of the exact solves of an island, in multiply-adds per column and step, including re-solves: some
// 0.25 s.
inline constexpr double most_work_of_a_column = 1e9;
// Expected factorisations per column. An island that would exceed the bound with that many is swept.
inline constexpr double usual_factorisations = 25.0;

// Exact solver, see direct.cpp. `Termination::iterations` bounds the factorisations per column, and the sweeps if
// it fails.
std::unique_ptr<Solver> make_direct();

}  // namespace pushfactor::engine::solvers
