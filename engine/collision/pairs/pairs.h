// Contact of two shapes by pair: each function does what collide() and collide_along() (collide.h) say, for shapes
// in this order.
#pragma once

#include "engine/collision/manifold.h"
#include "engine/collision/pairs/placed_hull.h"

namespace pushfactor::engine::collision {

// Separating axes, then clipping of the incident face to the reference face (paper section 4). The feature of a
// point encodes the two faces and the two edges that made it, or the two crossing edges.
void collide_box_box(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b, double margin,
                     Manifold& manifold);

// The same for polyhedra, with the choices of box_box.cpp: a cube given as a polyhedron behaves as a box. Boxes
// take part as polyhedra.
void collide_hulls(const PlacedHull& a, const PlacedHull& b, double margin, Manifold& manifold);
void collide_hulls_along(const Vector3& normal, const PlacedHull& a, const PlacedHull& b, double margin,
                         Manifold& manifold);

// The corners below the plane, or the lowest point of the sphere. The feature of a point is the number of the
// corner.
void collide_with_plane(const Box& box, const Pose& pose, const Pose& plane_pose, double margin,
                        Manifold& manifold);
void collide_with_plane(const Polyhedron& polyhedron, const Pose& pose, const Pose& plane_pose, double margin,
                        Manifold& manifold);
void collide_with_plane(const Sphere& sphere, const Pose& pose, const Pose& plane_pose, double margin,
                        Manifold& manifold);

// One point, feature 0. If the centres of two spheres coincide the direction is the world's y axis; if the centre
// of the sphere is inside the other shape, it is that of the closest face.
void collide_with_sphere(const Sphere& a, const Pose& pose_a, const Sphere& b, const Pose& pose_b, double margin,
                         Manifold& manifold);
void collide_with_sphere(const Box& box, const Pose& pose, const Sphere& sphere, const Pose& sphere_pose,
                         double margin, Manifold& manifold);
void collide_with_sphere(const Polyhedron& polyhedron, const Pose& pose, const Sphere& sphere,
                         const Pose& sphere_pose, double margin, Manifold& manifold);
// `normal`: outward. The sphere's extreme point along it, unless that lies beside the face.
void collide_hull_sphere_along(const Vector3& normal, const PlacedHull& placed, const Sphere& sphere,
                               const Pose& sphere_pose, double margin, Manifold& manifold);

}  // namespace pushfactor::engine::collision
