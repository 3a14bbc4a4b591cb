// Pairs with a polyhedron: separating axes, then clipping of the incident face to the reference face (paper
// section 4), with the choices of box_box.cpp: a cube given as a polyhedron behaves as a box. Boxes take part as
// polyhedra.
#pragma once

#include "engine/collision/manifold.h"
#include "engine/collision/pairs/hull_axes.h"

namespace pushfactor::engine::collision {

// As collide(), see pair_table.h. The feature of a point encodes the reference face and the two edges that made
// it, or the two crossing edges. Of more than eight points the outermost in eight directions are kept.
void collide_hulls(const PlacedHull& a, const PlacedHull& b, double margin, Manifold& manifold);

// The same along `axis`, one of the separations of the hulls, even if it is not the best. Points may lie up to
// `room` [m] beside their face.
void collide_hulls_along(const Separation& axis, const PlacedHull& a, const PlacedHull& b, double room,
                         double margin, Manifold& manifold);

// The vertices below the plane; the feature of a point is the number of the vertex.
void collide_polyhedron_plane(const Polyhedron& polyhedron, const Pose& pose, const Plane& plane,
                              const Pose& plane_pose, double margin, Manifold& manifold);

// One point, feature 0. If the centre of the sphere is inside, the direction is that of the closest face.
void collide_polyhedron_sphere(const Polyhedron& polyhedron, const Pose& pose, const Sphere& sphere,
                               const Pose& sphere_pose, double margin, Manifold& manifold);

// Calls `visit` with the face axes of the polyhedron, from it to the sphere.
template <typename Visit>
void visit_separations(const Polyhedron& polyhedron, const Pose& pose, const Sphere& sphere,
                       const Pose& sphere_pose, const Visit& visit) {
    const Vector3 centre = pose.rotation.transpose() * (sphere_pose.position - pose.position);
    const Hull& hull = polyhedron.mesh->hull();
    for (int f = 0; f < static_cast<int>(hull.faces.size()); ++f) {
        const HullFace& face = hull.face(f);
        const double gap = face.normal.dot(centre) - face.offset - sphere.radius;
        visit(Separation{pose.rotation * face.normal, gap, f, -1});
    }
}

// The same along `axis`, one of these: the sphere's extreme point along it, unless that lies beside the face by
// more than `room` [m].
void collide_polyhedron_sphere_along(const Separation& axis, const Polyhedron& polyhedron, const Pose& pose,
                                     const Sphere& sphere, const Pose& sphere_pose, double room, double margin,
                                     Manifold& manifold);

}  // namespace pushfactor::engine::collision
