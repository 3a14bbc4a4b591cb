// Box against box: separating axes, then clipping of the incident face to the reference face (paper section 4).
#pragma once

#include "engine/collision/collider.h"
#include "engine/collision/manifold.h"

namespace pushfactor::engine::collision {

// Box-box collide(), see pair_table.h. The feature of a point encodes the two faces and the two edges that made
// it, or the two crossing edges.
void collide_box_box(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b, double margin,
                     Manifold& manifold);

}  // namespace pushfactor::engine::collision
