// RATTLE, in place of the integrator of section 3.2 for scenes whose rows are all bars: symmetric in time and of
// second order, with momenta that belong to the same instant as the positions; composed with itself, of fourth and
// sixth order. Half a kick, move, half a kick:
//
//   p'      = p(t) + dt/2 (f(t) + J(t)^T lambda)               lambda such that c(t + dt) = 0, not c'
//   x, o    = moved for dt with p', as after 3.2.2
//   p(t+dt) = p' + dt/2 (f(t+dt) + J(t+dt)^T lambda')          lambda' such that c'(t + dt) = 0
//
// Symbols as in world.h; c(t) the length errors of the bars [m]; p stands for both momenta, f for force and torque.
// Each line is the system equation 6.2.9 with dt/2 for dt. lambda is found by repetition: a source says with the
// push of its rows at the place that was tried how far that place is off, and the system with that push on the
// right side says which force is missing. Without bars it is the leapfrog.
//
// Deviations: 3.2 wants Euler where constraints act, because "the constraint solver assumes" it. What the solver
// assumes is that rows are velocities; here the position is what is solved for, with the same rows. 3.2 also
// suggests RK4 for bodies that fly freely. No force that exists depends on the position, and for those
// the leapfrog is the parabola itself; tumbling is brought to the same order by the composition. So there is none.
//
// Sources must push by their whole error (DistanceConstraints with beta 1; persistent or single-frame is the same
// here). How exactly the bars are kept is up to the world's termination: to tolerance_high * dt [m]. With
// coupled rows an iterative solver needs tolerances of about 1e-12 m/s, or many iterations at tolerance 0, for the
// orders to show at small steps. A force that begins or ends lowers the order to one, also
// at the end of a step: the moves of a composition look back and ahead beyond it.
// A step so large that repeating does not bring the lengths nearer leaves them as they are, for all to see.
#pragma once

#include "engine/world.h"

namespace pushfactor::engine {

// A way to advance a world by dt [s]. `dt` below zero goes back in time.
using StepMethod = StepCount (*)(World& world, double dt);

// All throw InvalidInput when a row is not a bar (has bounds): contacts, ropes, struts, bars that yield. What they
// count is the sum over all solves of the step; rows, system and lambda of the world are those of the last one,
// where lambda is the force of the bars at the end of the step.
StepCount rattle(World& world, double dt);   // second order, 1 move a step
StepCount rattle4(World& world, double dt);  // fourth, 5 moves
StepCount rattle6(World& world, double dt);  // sixth, 7 moves

}  // namespace pushfactor::engine
