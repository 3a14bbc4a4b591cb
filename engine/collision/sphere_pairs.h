// The pairs in which one shape is a sphere: one point each, feature 0.
#pragma once

#include "engine/collision/collider.h"
#include "engine/collision/manifold.h"
#include "engine/collision/separations.h"

namespace pushfactor::engine::collision {

// All as collide() in pair_table.h. Where the centres coincide the direction is the world's y axis for two spheres,
// and the axis of least depth for a sphere whose centre is inside a box.
void collide_sphere_sphere(const Sphere& a, const Pose& pose_a, const Sphere& b, const Pose& pose_b, double margin,
                           Manifold& manifold);
void collide_box_sphere(const Box& box, const Pose& box_pose, const Sphere& sphere, const Pose& sphere_pose,
                        double margin, Manifold& manifold);
void collide_sphere_plane(const Sphere& sphere, const Pose& sphere_pose, const Plane& plane, const Pose& plane_pose,
                          double margin, Manifold& manifold);

// The same along `axis`, one of their Separations: a point where the sphere is farthest along it, unless that lies
// beside the face by more than `room` [m].
void collide_box_sphere_along(const Separation& axis, const Box& box, const Pose& box_pose, const Sphere& sphere,
                              const Pose& sphere_pose, double room, double margin, Manifold& manifold);

}  // namespace pushfactor::engine::collision
