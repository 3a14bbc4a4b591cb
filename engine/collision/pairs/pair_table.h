// Dispatch table of shape pairs.
#pragma once

#include "engine/collision/collider.h"
#include "engine/collision/manifold.h"

namespace pushfactor::engine::collision {

// Writes the points of `a` and `b` with a gap below `margin` [m, >= 0] into `manifold`, with the normal from a to
// b; none if they are apart, and nothing if the table has no function for the pair.
void collide(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, double margin,
             Manifold& manifold);

}  // namespace pushfactor::engine::collision
