// Largest useful time step. Each rule uses a state and the forces of the last step, and gives a rate [1/s]: a step
// of dt resolves the state while rate dt <= 1. A rate of 0 means no limit.
//
// Symbols: T tension of a bar [N], l its length [m], m mass of a body [kg], r distance of the bar's end from the
// centre of mass [m], s the part of r along the force [m], I smallest moment of inertia about an axis across r
// [kg m^2]: a turn about r moves no end of a bar, and without that a force changes no moment.
//
//   tension   Under T a bar swings back sideways with omega^2 = T sum over both ends of (1/m + r^2/I)/l + s/I. The
//             constraint is linearised (5.2.1), so this stiffness is explicit and needs omega dt < 2, like every
//             oscillator under semi-implicit Euler; 2 omega dt <= 1 conserves its energy too. In a ball joint with
//             force T bodies swing with omega^2 = T sum of s/I.
//   turning   A bar that turns by an angle a per step leaves its circle by l a^2 / 2: a <= 0.034. The same for a
//             body that turns about a joint, by r a^2 / 2. A spin about r turns a hinge, but no ball joint: there
//             it counts no more than the nodding L/I that its angular momentum L makes of a push, which is all of
//             the spin of a disc on its axle and little of that of a slender bar.
#pragma once

#include "engine/constraints/distance_constraints.h"
#include "engine/constraints/joint_constraints.h"

#include <span>

namespace pushfactor::engine {

// All in 1/s. Loose ropes and struts do not count.
double tension_rate(const DistanceConstraints& distances, std::span<const Body> bodies);
double turning_rate(const DistanceConstraints& distances, std::span<const Body> bodies);
// The same for joints.
double tension_rate(const JointConstraints& joints, std::span<const Body> bodies);
double turning_rate(const JointConstraints& joints, std::span<const Body> bodies);

}  // namespace pushfactor::engine
