// Which pairs of shapes collide, and by which function.
#pragma once

#include "engine/collision/collider.h"
#include "engine/collision/manifold.h"

namespace pushfactor::engine::collision {

// Writes the points of `a` and `b` whose gap is below `margin` [m, >= 0] into `manifold`, up to eight, with the
// normal from a to b. None when they are apart, or when the table has no function for the pair.
void collide(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, double margin,
             Manifold& manifold);

}  // namespace pushfactor::engine::collision
