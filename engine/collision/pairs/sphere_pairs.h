// Pairs with a sphere: one point each, feature 0.
#pragma once

#include "engine/collision/collider.h"
#include "engine/collision/manifold.h"

namespace pushfactor::engine::collision {

// Share of the radius by which a centre may be beside a face and still count as above it. Otherwise the edge
// normals would unbalance a sphere that lies where the edges of four boxes meet.
inline constexpr double beside_rounding = 1e-6;

// Adds the point of a sphere with another shape. `surface` is the closest point of that shape; `normal` points from
// it to the sphere.
void add_sphere_point(const Vector3& surface, const Vector3& normal, double gap, double margin, Manifold& manifold);

// See collide() in pair_table.h. If the centres coincide the direction is the world's y axis for two spheres;
// for a sphere whose centre is inside a box it is the axis of least depth.
void collide_sphere_sphere(const Sphere& a, const Pose& pose_a, const Sphere& b, const Pose& pose_b, double margin,
                           Manifold& manifold);
void collide_box_sphere(const Box& box, const Pose& box_pose, const Sphere& sphere, const Pose& sphere_pose,
                        double margin, Manifold& manifold);
void collide_sphere_plane(const Sphere& sphere, const Pose& sphere_pose, const Plane& plane, const Pose& plane_pose,
                          double margin, Manifold& manifold);

}  // namespace pushfactor::engine::collision
