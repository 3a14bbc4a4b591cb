// Contact of two shapes, whichever they are.
#pragma once

#include "engine/collision/collider.h"
#include "engine/collision/manifold.h"

namespace pushfactor::engine::collision {

// Writes the points of `a` and `b` with a gap below `margin` [m, >= 0] into `manifold`, with the normal from a to
// b; none if they are apart, or are two planes.
void collide(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, double margin,
             Manifold& manifold);

// The same along the face axis that is `normal` (unit length, from a to b) up to rounding, even if it is not the
// best; none if neither shape has such a face.
void collide_along(const Vector3& normal, const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b,
                   double margin, Manifold& manifold);

}  // namespace pushfactor::engine::collision
