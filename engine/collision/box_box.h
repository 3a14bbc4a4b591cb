// Box against box: separating axes, then clipping of the incident face to the reference face (paper section 4).
#pragma once

#include "engine/collision/collider.h"
#include "engine/collision/manifold.h"

namespace pushfactor::engine::collision {

// As collide() in pair_table.h. The feature of a point names the two faces and the two edges that made it, or the
// two edges that cross.
void collide_box_box(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b, double margin,
                     Manifold& manifold);

}  // namespace pushfactor::engine::collision
