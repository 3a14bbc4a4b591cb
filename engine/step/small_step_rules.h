// Rules for dividing an island's step into small steps (small_steps.h).
#pragma once

#include "engine/bodies/body.h"
#include "engine/system/islands.h"

#include <span>

namespace pushfactor::engine {

struct SmallStepDivision {
    int steps = 1;
    int sweeps = 1;  // per small step
};

namespace small_step_rules {

// Residual of the warm start [m/s] up to which sweeps of a whole step are enough: so small that it need not travel,
// and afterwards the forces can be kept.
//
// Infinite for islands not suited for small steps: few bodies, for which sweeps of a whole step converge; bars that
// act both ways, because sweeps leave an error in every small step, and for these either sign does harm; and rows
// that bounce or keep their push in the momenta, because a collision that one small step passes on to the next
// happens twice.
double largest_to_sweep(double dt, std::span<const Body> bodies, const Island& island);

// Residual of the warm start [m/s] up to which an exact solution may last: no more than the external forces of the
// step cause, if nearly all bodies are slower than these make them; otherwise zero.
double standing_speed(double dt, std::span<const Body> bodies, const Island& island);

// Division for an island with this residual of the warm start [m/s]: many small steps with many sweeps if it has to
// carry load, fewer sweeps if most of it moves with little load or some of it is hit, and also fewer steps if most
// of it moves and is hit.
SmallStepDivision division_of(double dt, std::span<const Body> bodies, const Island& island, double residual);

}  // namespace small_step_rules

}  // namespace pushfactor::engine
