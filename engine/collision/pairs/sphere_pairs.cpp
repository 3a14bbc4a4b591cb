#include "engine/collision/pairs/sphere_pairs.h"

#include <cmath>

namespace pushfactor::engine::collision {

void add_sphere_point(const Vector3& surface, const Vector3& normal, double gap, double margin,
                      Manifold& manifold) {
    manifold.normal = normal;
    manifold.separation = gap;
    if (gap < margin) manifold.add({surface + (0.5 * gap) * normal, gap, 0});
}

void collide_sphere_sphere(const Sphere& a, const Pose& pose_a, const Sphere& b, const Pose& pose_b, double margin,
                           Manifold& manifold) {
    const Vector3 offset = pose_b.position - pose_a.position;
    const double distance = offset.norm();
    const Vector3 normal = distance > 0.0 ? Vector3(offset / distance) : Vector3::UnitY();
    add_sphere_point(pose_a.position + a.radius * normal, normal, distance - a.radius - b.radius, margin, manifold);
}

void collide_sphere_plane(const Sphere& sphere, const Pose& sphere_pose, const Plane&, const Pose& plane_pose,
                          double margin, Manifold& manifold) {
    const Vector3 up = plane_pose.rotation.col(1);
    const double height = up.dot(sphere_pose.position - plane_pose.position);
    add_sphere_point(sphere_pose.position - height * up, up, height - sphere.radius, margin, manifold);
    manifold.normal = -up;
}

void collide_box_sphere(const Box& box, const Pose& box_pose, const Sphere& sphere, const Pose& sphere_pose,
                        double margin, Manifold& manifold) {
    const Vector3 centre = box_pose.rotation.transpose() * (sphere_pose.position - box_pose.position);
    const Vector3 reach = box.half_size.array() + beside_rounding * sphere.radius;
    const Vector3 beside = centre.cwiseAbs() - reach;
    const Vector3 nearest =
        (beside.array() > 0.0).select(centre.cwiseMax(-box.half_size).cwiseMin(box.half_size), centre);
    const Vector3 offset = centre - nearest;
    const double distance = offset.norm();
    if (distance > 1e-12 * sphere.radius) {
        add_sphere_point(box_pose.position + box_pose.rotation * nearest, box_pose.rotation * (offset / distance),
                         distance - sphere.radius, margin, manifold);
        // Outside more than one face: the closest point is on an edge or a corner.
        if ((beside.array() > 0.0).count() > 1) {
            manifold.other_gap = (centre.cwiseAbs() - box.half_size).maxCoeff() - sphere.radius;
        }
        return;
    }
    // Centre inside the box: push out through the closest face; y first among equals.
    const Vector3 depth = box.half_size - centre.cwiseAbs();
    int axis = 1;
    for (const int other : {0, 2}) {
        if (depth[other] < depth[axis]) axis = other;
    }
    Vector3 out = Vector3::Zero();
    out[axis] = centre[axis] < 0.0 ? -1.0 : 1.0;
    const Vector3 surface = centre + out * depth[axis];
    add_sphere_point(box_pose.position + box_pose.rotation * surface, box_pose.rotation * out,
                     -depth[axis] - sphere.radius, margin, manifold);
}

}  // namespace pushfactor::engine::collision
