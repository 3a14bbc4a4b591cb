// Corners below an infinite plane.
#include "engine/collision/pairs/pairs.h"

#include <algorithm>

namespace pushfactor::engine::collision {

namespace {

// `corner(k)`: in the body frame, m.
template <typename Corner>
void add_below(const Pose& plane_pose, const Pose& pose, std::size_t corners, const Corner& corner, double margin,
               Manifold& manifold) {
    const Vector3 up = plane_pose.rotation.col(1);
    manifold.normal = -up;
    for (std::size_t k = 0; k < corners; ++k) {
        const Vector3 point = pose.position + pose.rotation * corner(k);
        const double gap = up.dot(point - plane_pose.position);
        manifold.separation = std::min(manifold.separation, gap);
        if (gap < margin) manifold.add({point - (0.5 * gap) * up, gap, static_cast<std::uint32_t>(k)});
    }
}

}  // namespace

void collide_with_plane(const Box& box, const Pose& pose, const Pose& plane_pose, double margin,
                        Manifold& manifold) {
    const auto corner = [&](std::size_t k) -> Vector3 {
        return Vector3((k & 1u) ? 1.0 : -1.0, (k & 2u) ? 1.0 : -1.0, (k & 4u) ? 1.0 : -1.0)
            .cwiseProduct(box.half_size);
    };
    add_below(plane_pose, pose, 8, corner, margin, manifold);
}

void collide_with_plane(const Polyhedron& polyhedron, const Pose& pose, const Pose& plane_pose, double margin,
                        Manifold& manifold) {
    const std::span<const Vector3> vertices = polyhedron.mesh->hull().vertices;
    const auto corner = [&](std::size_t k) { return vertices[k]; };
    manifold.rounded = true;
    add_below(plane_pose, pose, vertices.size(), corner, margin, manifold);
}

}  // namespace pushfactor::engine::collision
