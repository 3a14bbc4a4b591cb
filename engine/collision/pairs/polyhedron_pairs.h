// Pairs with a polyhedron: separating axes, then clipping of the incident face to the reference face (paper
// section 4), with the choices of box_box.cpp: a cube given as a polyhedron behaves as a box. Boxes take part as
// polyhedra.
#pragma once

#include "engine/collision/manifold.h"
#include "engine/collision/pairs/hull_axes.h"

namespace pushfactor::engine::collision {

// As collide(), see pair_table.h. The feature of a point encodes the reference face and the two edges that made
// it, or the two crossing edges.
void collide_hulls(const PlacedHull& a, const PlacedHull& b, double margin, Manifold& manifold);

// The same along the face axis that is `normal` (unit length, from a to b) up to rounding, even if it is not the
// best; none if neither has such a face.
void collide_hulls_along(const Vector3& normal, const PlacedHull& a, const PlacedHull& b, double margin,
                         Manifold& manifold);

// The vertices below the plane; the feature of a point is the number of the vertex.
void collide_polyhedron_plane(const Polyhedron& polyhedron, const Pose& pose, const Plane& plane,
                              const Pose& plane_pose, double margin, Manifold& manifold);

// One point, feature 0. If the centre of the sphere is inside, the direction is that of the closest face.
void collide_polyhedron_sphere(const Polyhedron& polyhedron, const Pose& pose, const Sphere& sphere,
                               const Pose& sphere_pose, double margin, Manifold& manifold);

// The same along the face axis that is `normal` (unit length, outward) up to rounding: the sphere's extreme point
// along it, unless that lies beside the face.
void collide_hull_sphere_along(const Vector3& normal, const PlacedHull& placed, const Sphere& sphere,
                               const Pose& sphere_pose, double margin, Manifold& manifold);

}  // namespace pushfactor::engine::collision
