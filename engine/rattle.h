// RATTLE, an alternative to the integrator of section 3.2 for scenes whose rows are all bars: symmetric in time and
// second order, with momenta at the same time as the positions; as a composition, fourth and sixth order. Half
// kick, drift, half kick:
//
//   p'      = p(t) + dt/2 (f(t) + J(t)^T lambda)               lambda such that c(t + dt) = 0, not c'
//   x, o    = moved for dt with p', as after 3.2.2
//   p(t+dt) = p' + dt/2 (f(t+dt) + J(t+dt)^T lambda')          lambda' such that c'(t + dt) = 0
//
// Symbols: as in world.h; c(t) length errors of the bars [m]; p stands for both momenta, f for force and torque.
//
// Each line is the system equation 6.2.9 with dt/2 for dt. lambda is found by iteration: the push of a source's
// rows at the predicted positions gives their error, and the system with that push on the right-hand side gives the
// missing force. Without bars it is the leapfrog.
//
// Deviations: 3.2 requires Euler where constraints act, because "the constraint solver assumes" it. What the solver
// assumes is that rows are velocities; here it solves for positions, with the same rows. 3.2 also suggests RK4 for
// free bodies. No existing force depends on the position, so the leapfrog gives the exact parabola; tumbling
// reaches the same order by the composition. So there is no RK4.
//
// Sources must push by their whole error (DistanceConstraints with beta 1; persistent and single-frame are the same
// here). The world's termination sets the accuracy of the bars: tolerance_high * dt [m]. With coupled rows an
// iterative solver needs tolerances of about 1e-12 m/s, or many iterations at tolerance 0, for the orders to show
// at small steps. A force that begins or ends reduces the order to one, also at the end of a step, because the
// moves of a composition reach beyond it. If the step is so large that the iteration does not reduce the length
// errors, they remain visible.
#pragma once

#include "engine/world.h"

namespace pushfactor::engine {

// Advances a world by dt [s]. `dt` below zero goes back in time.
using StepMethod = StepCount (*)(World& world, double dt);

// All throw InvalidInput if a row is not a bar (has bounds): contacts, ropes, struts, yielding bars. Counts are
// sums over all solves of the step; rows, system and lambda of the world are those of the last solve, where lambda
// is the force of the bars at the end of the step.
StepCount rattle(World& world, double dt);   // second order, 1 move per step
StepCount rattle4(World& world, double dt);  // fourth, 5 moves
StepCount rattle6(World& world, double dt);  // sixth, 7 moves

}  // namespace pushfactor::engine
