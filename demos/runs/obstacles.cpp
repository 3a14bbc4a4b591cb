#include "demos/runs/obstacles.h"

#include "engine/base/overloaded.h"
#include "engine/collision/polyhedron.h"

#include <algorithm>

namespace pushfactor::demos {

namespace {

using engine::Vector3;

// Whether the segment between two places in the frame of a box crosses one of its middle planes inside it.
bool crosses_middle(const Vector3& from, const Vector3& to, const Vector3& half_size) {
    for (int axis = 0; axis < 3; ++axis) {
        if ((from[axis] < 0.0) == (to[axis] < 0.0)) continue;
        const Vector3 at = from + from[axis] / (from[axis] - to[axis]) * (to - from);
        if ((at.cwiseAbs().array() <= half_size.array()).all()) return true;
    }
    return false;
}

// The same for the polyhedron of half its size about its centre.
bool crosses_core(const Vector3& from, const Vector3& to, const engine::collision::Hull& hull) {
    double enters = 0.0, leaves = 1.0;  // shares of the way
    for (const engine::collision::HullFace& face : hull.faces) {
        const double at_from = face.normal.dot(from) - 0.5 * face.offset,
                     at_to = face.normal.dot(to) - 0.5 * face.offset;
        if (at_from > 0.0 && at_to > 0.0) return false;
        if (at_from > 0.0) enters = std::max(enters, at_from / (at_from - at_to));
        if (at_to > 0.0) leaves = std::min(leaves, at_from / (at_from - at_to));
    }
    return enters < leaves;
}

double distance_to_way(const Vector3& point, const Vector3& from, const Vector3& to) {
    const Vector3 way = to - from;
    const double length = way.squaredNorm();
    const double share = length > 0.0 ? std::clamp((point - from).dot(way) / length, 0.0, 1.0) : 0.0;
    return (from + share * way - point).norm();
}

}  // namespace

Obstacles::Pose Obstacles::pose_of(const engine::Body& body) {
    return {body.position, body.orientation.conjugate().toRotationMatrix()};
}

Obstacles::Obstacles(const BuiltScene& scene) {
    if (!scene.contacts) return;
    for (const auto& collider : scene.contacts->colliders()) {
        const engine::Body& body = scene.world.bodies[static_cast<std::size_t>(collider.body)];
        if (body.is_static()) all_.push_back({collider.body, pose_of(body), pose_of(body), collider.shape});
    }
}

void Obstacles::follow(const BuiltScene& scene) {
    if (!scene.world.moves_any()) return;
    for (Obstacle& obstacle : all_) {
        obstacle.before = obstacle.now;
        obstacle.now = pose_of(scene.world.bodies[static_cast<std::size_t>(obstacle.body)]);
    }
}

bool Obstacles::is_behind_plane(const Vector3& centre) const {
    return std::ranges::any_of(all_, [&](const Obstacle& obstacle) {
        return std::holds_alternative<engine::collision::Plane>(obstacle.shape) &&
               obstacle.now.from_world.row(1).dot(centre - obstacle.now.centre) < 0.0;
    });
}

bool Obstacles::is_passed(const Vector3& from, const Vector3& to) const {
    return std::ranges::any_of(all_, [&](const Obstacle& obstacle) {
        const Vector3 a = obstacle.before.in_frame(from), b = obstacle.now.in_frame(to);
        return std::visit(
            engine::Overloaded{
                [](const engine::collision::Plane&) { return false; },
                [&](const engine::collision::Box& box) { return crosses_middle(a, b, box.half_size); },
                [&](const engine::collision::Sphere& sphere) {
                    return distance_to_way(Vector3::Zero(), a, b) < 0.5 * sphere.radius;
                },
                [&](const engine::collision::Polyhedron& polyhedron) {
                    return crosses_core(a, b, polyhedron.mesh->hull());
                }},
            obstacle.shape);
    });
}

}  // namespace pushfactor::demos
