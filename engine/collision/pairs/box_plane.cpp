#include "engine/collision/pairs/box_plane.h"

#include <algorithm>

namespace pushfactor::engine::collision {

void collide_box_plane(const Box& box, const Pose& box_pose, const Plane&, const Pose& plane_pose, double margin,
                       Manifold& manifold) {
    const Vector3 up = plane_pose.rotation.col(1);
    manifold.normal = -up;
    for (unsigned corner = 0; corner < 8; ++corner) {
        const Vector3 sign((corner & 1u) ? 1.0 : -1.0, (corner & 2u) ? 1.0 : -1.0, (corner & 4u) ? 1.0 : -1.0);
        const Vector3 point = box_pose.position + box_pose.rotation * sign.cwiseProduct(box.half_size);
        const double gap = up.dot(point - plane_pose.position);
        manifold.separation = std::min(manifold.separation, gap);
        if (gap < margin) manifold.add({point - (0.5 * gap) * up, gap, corner});
    }
}

}  // namespace pushfactor::engine::collision
