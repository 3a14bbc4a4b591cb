#pragma once

#include "engine/solvers/solver.h"

namespace pushfactor::engine::solvers {

// What the exact answer of an island may cost, in multiply-adds per column and step, all looks together: some 0.25
// s.
inline constexpr double most_work_of_a_column = 1e9;
// Factorisations that a column usually takes when it cannot be told beforehand. An island that so many would bring
// beyond the bound is swept.
inline constexpr double usual_factorisations = 25.0;

// The exact answer, see direct.cpp. `Termination::iterations` bounds the factorisations of a column, and the sweeps
// that follow where they do not get there.
std::unique_ptr<Solver> make_direct();

}  // namespace pushfactor::engine::solvers
