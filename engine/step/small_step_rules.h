// When an island goes through a step in small ones (small_steps.h), and in how many.
#pragma once

#include "engine/bodies/body.h"
#include "engine/system/islands.h"

#include <span>

namespace pushfactor::engine {

struct SmallStepDivision {
    int steps = 1;
    int sweeps = 1;  // of each
};

namespace small_step_rules {

// Residual of a guess [m/s] up to which sweeps of a whole step finish what is left: so little that it need not
// travel, and when they are done the forces can be kept.
//
// Infinite where small steps are not for the island: a few bodies, whose sweeps get somewhere in a whole step; bars
// that act both ways, because sweeps leave them a little wrong in every small step, and what they are wrong by has
// no side on which it does no harm; and what bounces or keeps its push in the momenta, because a collision that a
// small step takes over from the one before happens twice.
double largest_to_sweep(double dt, std::span<const Body> bodies, const Island& island);

// Residual of a guess [m/s] up to which an exact answer may serve for good: no more than the external forces of the
// step, where nearly all bodies are slower than these make them. Zero where they are not.
double standing_speed(double dt, std::span<const Body> bodies, const Island& island);

// What suits the island, whose guess has this residual [m/s]: many small steps of many sweeps where it is to carry
// load, fewer sweeps where most of it moves with little to carry or some is hit, and fewer steps too where most of
// it moves and is hit.
SmallStepDivision division_of(double dt, std::span<const Body> bodies, const Island& island, double residual);

}  // namespace small_step_rules

}  // namespace pushfactor::engine
