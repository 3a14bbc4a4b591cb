// How an island is solved in a step: directly, or in small steps, and how many. Every rule uses the island and its
// state alone, and no memory of earlier steps.
//
//   - An island whose guess is good enough is not solved (island_solver.h).
//   - One that stands, or is small, or has bars or joints, is solved directly if that costs no more than a few
//   small
//     steps; one that has no forces yet, or nearly the right ones, may cost more, because once found they last.
//   - Everything else takes small steps: where most moves, few, because impacts change it anyway; else more,
//   because
//     what carries load is compressed by g h^2.
#pragma once

#include "engine/bodies/body.h"
#include "engine/step/small_steps.h"
#include "engine/system/islands.h"

#include <span>

namespace pushfactor::engine::choice {

// Whether small steps suit the island. A single body is always solved directly; and a row that bounces would bounce
// again in the next small step.
bool divides(const Island& island);

// Whether a direct solution is tried before small steps are taken.
bool is_tried_directly(double dt, std::span<const Body> bodies, const Island& island);

// Whether hardly any of its bodies is faster than its external force makes it in this step of `dt` [s].
bool stands(double dt, std::span<const Body> bodies, const Island& island);

// Largest speed that the external forces of a step give a body [m/s].
double speed_by_forces(double dt, std::span<const Body> bodies, const Island& island);

SmallStepDivision division_of(double dt, std::span<const Body> bodies, const Island& island);

// Residual [m/s] up to which a guess is good enough. Kept forces under a stack are an inverted pendulum: an error
// grows while nothing is solved. So there are two tolerances, and a few bodies, whose solution costs hardly more
// than a look at the guess, are solved as soon as they miss the lower one.
double tolerance_of_guess(const Island& island, const solvers::Termination& usual);

// Sets what a direct solution of the island is worth, whose guess has this residual [m/s] and forces or none.
// `divided`: small steps are taken instead, else sweeps of the whole step.
void set_worth(double dt, std::span<const Body> bodies, const Island& island, double residual, bool has_forces,
               bool divided, solvers::Termination& termination);

}  // namespace pushfactor::engine::choice
