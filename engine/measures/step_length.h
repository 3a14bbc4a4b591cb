// How long a step may be. Each rule looks at a state and at the forces that are remembered of the last step, and
// gives a rate [1/s]: a step of dt follows the state while rate dt <= 1. A state that asks for nothing has rate 0.
//
// Symbols: T tension of a bar [N], l its length [m], m mass and I smallest principal moment of inertia of a body
// [kg, kg m^2], r distance of the bar's end from the centre of mass [m], g gravity [m/s^2], L size of a body [m].
//
//   tension   Under T a bar swings back sideways with omega^2 = T sum over both ends of (1/m + r^2/I)/l + r/I. The
//             constraint is linearised (5.2.1), so that this stiffness is explicit and needs omega dt < 2, as
//             every oscillator under semi-implicit Euler; 2 omega dt <= 1 keeps its energy too.
//             A ball joint that carries T swings its bodies with omega^2 = T sum of r/I.
//   turning   A bar that turns by an angle a in a step leaves its circle by l a^2 / 2: a <= 0.1. So does a body
//   that
//             turns about a ball joint, by r a^2 / 2.
//   spin      The same for a slender body, whose ends move fast: |omega| dt <= 0.1.
//   size      A small body falls through itself in a step of rest: g dt^2 <= 0.02 L.
#pragma once

#include "engine/collision/collider.h"
#include "engine/constraints/distance_constraints.h"

#include <span>

namespace pushfactor::engine {

// All in 1/s. Loose ropes and struts are no bars.
double tension_rate(const DistanceConstraints& distances, std::span<const Body> bodies);
double turning_rate(const DistanceConstraints& distances, std::span<const Body> bodies);
double spin_rate(std::span<const Body> bodies);
double size_rate(std::span<const collision::Collider> colliders, std::span<const Body> bodies,
                 const Vector3& gravity);

// Whether the largest moment of inertia of a movable body is more than ten times the smallest, as that of a box
// five times as long as wide.
bool is_slender(const Body& body);

}  // namespace pushfactor::engine
