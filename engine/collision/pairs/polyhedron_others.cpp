// Polyhedron against plane and against sphere.
#include "engine/collision/pairs/axis_choice.h"
#include "engine/collision/pairs/polyhedron_pairs.h"
#include "engine/collision/pairs/sphere_pairs.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine::collision {

namespace {

// The largest distance of `point` from the side planes of a face, along the plane of the face [m]; negative within.
double beside(const Hull& hull, const HullFace& face, const Vector3& point) {
    double most = -infinity;
    for (const Hull::Corner& corner : hull.corners_of(face)) {
        const HullEdge& edge = hull.edge(corner.edge);
        const Vector3 out =
            (edge.from == corner.vertex ? edge.direction : Vector3(-edge.direction)).cross(face.normal);
        most = std::max(most, out.dot(point - hull.vertex(corner.vertex)));
    }
    return most;
}

struct Nearest {
    Vector3 point = Vector3::Zero();  // m, of the surface
    Vector3 out = Vector3::Zero();    // unit length, towards the centre of the sphere
    double distance = infinity;       // m
};

// The closest point on the edges and vertices of the faces that `centre` is above.
Nearest nearest_on_edges(const Hull& hull, const Vector3& centre) {
    Nearest nearest;
    for (const HullEdge& edge : hull.edges) {
        const auto above = [&](int f) { return hull.face(f).normal.dot(centre) > hull.face(f).offset; };
        if (!above(edge.left) && !above(edge.right)) continue;
        const Vector3& from = hull.vertex(edge.from);
        const double along = std::clamp(edge.direction.dot(centre - from), 0.0, edge.length);
        const Vector3 point = from + along * edge.direction;
        const double distance = (centre - point).norm();
        if (distance < nearest.distance) nearest = {point, (centre - point) / distance, distance};
    }
    return nearest;
}

}  // namespace

void collide_polyhedron_plane(const Polyhedron& polyhedron, const Pose& pose, const Plane&, const Pose& plane_pose,
                              double margin, Manifold& manifold) {
    const Vector3 up = plane_pose.rotation.col(1);
    const Hull& hull = polyhedron.mesh->hull();
    manifold.normal = -up;
    manifold.rounded = true;
    for (std::size_t k = 0; k < hull.vertices.size(); ++k) {
        const Vector3 point = pose.position + pose.rotation * hull.vertices[k];
        const double gap = up.dot(point - plane_pose.position);
        manifold.separation = std::min(manifold.separation, gap);
        if (gap < margin) manifold.add({point - (0.5 * gap) * up, gap, static_cast<std::uint32_t>(k)});
    }
}

void collide_polyhedron_sphere(const Polyhedron& polyhedron, const Pose& pose, const Sphere& sphere,
                               const Pose& sphere_pose, double margin, Manifold& manifold) {
    const Hull& hull = polyhedron.mesh->hull();
    const Vector3 centre = pose.rotation.transpose() * (sphere_pose.position - pose.position);
    const auto height = [&](const HullFace& face) { return face.normal.dot(centre) - face.offset; };
    // The first among equal faces.
    const HullFace* highest = &hull.faces.front();
    for (const HullFace& face : hull.faces) {
        if (height(face) > height(*highest) + beside_rounding * sphere.radius) highest = &face;
    }
    const double above = height(*highest);
    if (above >= margin + sphere.radius) {
        manifold.normal = pose.rotation * highest->normal;
        manifold.separation = above - sphere.radius;
        return;
    }
    // Inside, or above the face: if the closest point is on a face, it is on the highest one.
    const bool inside = above <= beside_rounding * sphere.radius;
    if (inside || beside(hull, *highest, centre) <= beside_rounding * sphere.radius) {
        const Vector3 normal = pose.rotation * highest->normal;
        add_sphere_point(sphere_pose.position - above * normal, normal, above - sphere.radius, margin, manifold);
        return;
    }
    const Nearest nearest = nearest_on_edges(hull, centre);
    add_sphere_point(pose.position + pose.rotation * nearest.point, pose.rotation * nearest.out,
                     nearest.distance - sphere.radius, margin, manifold);
    manifold.other_gap = above - sphere.radius;
}

void collide_hull_sphere_along(const Vector3& normal, const PlacedHull& placed, const Sphere& sphere,
                               const Pose& sphere_pose, double margin, Manifold& manifold) {
    const Hull& hull = placed.hull();
    const Pose& pose = placed.pose();
    const Vector3 direction = pose.rotation.transpose() * normal;
    const Vector3 centre = pose.rotation.transpose() * (sphere_pose.position - pose.position);
    for (const HullFace& face : hull.faces) {
        if (face.normal.dot(direction) < same_axis || beside(hull, face, centre) > 0.0) continue;
        const double above = face.normal.dot(centre) - face.offset;
        const Vector3 up = pose.rotation * face.normal;
        add_sphere_point(sphere_pose.position - above * up, up, above - sphere.radius, margin, manifold);
        return;
    }
}

}  // namespace pushfactor::engine::collision
