#include "demos/scenes/polyhedron_shape.h"

#include "demos/scenes/convex_hull.h"
#include "demos/scenes/scene_description.h"
#include "engine/bodies/solid.h"

#include <cmath>

namespace pushfactor::demos {

namespace {

using engine::Matrix3;
using engine::Vector3;

constexpr double rounding = 1e-13;  // of the size: a centre of mass that close to the origin is there

double length_of(std::span<const Vector3> points) {
    double length = 0.0;
    for (const Vector3& point : points) length = std::max(length, (point - points.front()).norm());
    return length;
}

}  // namespace

FramedPolyhedron make_polyhedron(std::span<const Vector3> points) {
    // Moved points are rounded, and their hull may have lost a corner: again until nothing changes.
    constexpr int most_rounds = 8;
    ConvexHull hull = convex_hull(points);
    engine::Solid solid = engine::solid_of(hull.points, hull.faces);
    FramedPolyhedron result;
    for (int i = 0; i < most_rounds; ++i) {
        const bool centred = solid.centre.norm() <= rounding * length_of(hull.points);
        const engine::PrincipalAxes principal = engine::principal_axes(solid.inertia);
        if (centred && principal.axes.isIdentity(0.0)) break;
        const Vector3 centre = centred ? Vector3::Zero() : solid.centre;
        for (Vector3& point : hull.points) point = principal.axes.transpose() * (point - centre);
        result.centre += result.axes * centre;
        result.axes = (result.axes * engine::Quaternion(principal.axes)).normalized();
        const std::vector<Vector3> moved = hull.points;
        hull = convex_hull(moved);
        solid = engine::solid_of(hull.points, hull.faces);
    }
    result.shape = {.mesh = std::make_shared<engine::collision::PolyhedronMesh>(hull.points, hull.faces),
                    .moments = solid.inertia.diagonal(),
                    .volume = solid.volume};
    return result;
}

void give_polyhedron(BodyDescription& body, const FramedPolyhedron& polyhedron) {
    Vector3 position = body.position;
    engine::Quaternion orientation = body.orientation;
    body.shape = polyhedron.shape;
    body.position += body.orientation * polyhedron.centre;
    body.orientation = body.orientation * polyhedron.axes;
    body.surface_velocity = polyhedron.axes.conjugate() * body.surface_velocity;
    if (!body.motion) return;
    auto* const poses = std::get_if<std::vector<TimedPose>>(&body.motion->kind);
    if (!poses) return;
    // Each becomes whole, because a turn about the frame of the points moves the centre of mass.
    for (TimedPose& pose : *poses) {
        position = pose.position.value_or(position);
        orientation = pose.orientation.value_or(orientation);
        pose.position = position + orientation * polyhedron.centre;
        pose.orientation = orientation * polyhedron.axes;
    }
}

}  // namespace pushfactor::demos
