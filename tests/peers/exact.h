// Reference motions for the measures.
#pragma once

#include "tests/peers/engine.h"

#include <vector>

namespace pushfactor::tests::peers {

// The angle from the vertical at 0, 1, ... steps, rad, of a ball released at `amplitude` [rad]: the centre of a
// ball on a massless bar (distance), or a ball rigidly connected to its bar, which turns about the pivot
// (rigid_arm). gravity > 0, m/s^2.
std::vector<double> exact_angles(const Body& ball, const Link& link, double gravity, double amplitude, Joint joint,
                                 std::size_t steps);

// The places of the movable bodies at 0, 1, ... steps: a chain of balls that hangs from the origin of the world and
// starts at rest in the x-y plane, each ball on a massless bar to the centre of the one above it (distance) or
// fixed to that bar (rigid_arm).
std::vector<std::vector<Vector3>> exact_chain(const Scene& scene, Joint joint, std::size_t steps);

// The attitude of a body that has turned freely for `time` [s].
Quaternion exact_attitude(const Body& body, double time);

}  // namespace pushfactor::tests::peers
