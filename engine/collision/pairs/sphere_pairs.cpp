// Pairs with a sphere: one point each.
#include "engine/collision/pairs/axis_choice.h"
#include "engine/collision/pairs/pairs.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine::collision {

namespace {

// Share of the radius by which a centre may be beside a face and still count as above it. Otherwise the edge
// normals would unbalance a sphere that lies where the edges of four boxes meet.
constexpr double beside_rounding = 1e-6;

// `surface` is the closest point of the other shape; `normal` points from it to the sphere.
void add_sphere_point(const Vector3& surface, const Vector3& normal, double gap, double margin,
                      Manifold& manifold) {
    manifold.normal = normal;
    manifold.separation = gap;
    if (gap < margin) manifold.add({surface + (0.5 * gap) * normal, gap, 0});
}

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

void collide_with_sphere(const Sphere& a, const Pose& pose_a, const Sphere& b, const Pose& pose_b, double margin,
                         Manifold& manifold) {
    const Vector3 offset = pose_b.position - pose_a.position;
    const double distance = offset.norm();
    const Vector3 normal = distance > 0.0 ? Vector3(offset / distance) : Vector3::UnitY();
    add_sphere_point(pose_a.position + a.radius * normal, normal, distance - a.radius - b.radius, margin, manifold);
}

void collide_with_plane(const Sphere& sphere, const Pose& sphere_pose, const Pose& plane_pose, double margin,
                        Manifold& manifold) {
    const Vector3 up = plane_pose.rotation.col(1);
    const double height = up.dot(sphere_pose.position - plane_pose.position);
    add_sphere_point(sphere_pose.position - height * up, up, height - sphere.radius, margin, manifold);
    manifold.normal = -up;
}

void collide_with_sphere(const Box& box, const Pose& pose, const Sphere& sphere, const Pose& sphere_pose,
                         double margin, Manifold& manifold) {
    const Vector3 centre = pose.rotation.transpose() * (sphere_pose.position - pose.position);
    const Vector3 reach = box.half_size.array() + beside_rounding * sphere.radius;
    const Vector3 beside = centre.cwiseAbs() - reach;
    const Vector3 nearest =
        (beside.array() > 0.0).select(centre.cwiseMax(-box.half_size).cwiseMin(box.half_size), centre);
    const Vector3 offset = centre - nearest;
    const double distance = offset.norm();
    if (distance > 1e-12 * sphere.radius) {
        add_sphere_point(pose.position + pose.rotation * nearest, pose.rotation * (offset / distance),
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
    add_sphere_point(pose.position + pose.rotation * surface, pose.rotation * out, -depth[axis] - sphere.radius,
                     margin, manifold);
}

void collide_with_sphere(const Polyhedron& polyhedron, const Pose& pose, const Sphere& sphere,
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
