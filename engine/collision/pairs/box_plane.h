// Box against infinite plane: the corners of the box that are below the plane.
#pragma once

#include "engine/collision/collider.h"
#include "engine/collision/manifold.h"

namespace pushfactor::engine::collision {

// Box-plane collide(), see pair_table.h. The feature of a point is the number of the corner.
void collide_box_plane(const Box& box, const Pose& box_pose, const Plane& plane, const Pose& plane_pose,
                       double margin, Manifold& manifold);

}  // namespace pushfactor::engine::collision
