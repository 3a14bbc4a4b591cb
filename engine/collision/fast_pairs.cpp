#include "engine/collision/fast_pairs.h"

namespace pushfactor::engine::collision {

namespace {

// Half the edges of a box around the shape, however it turns within the step [m].
Vector3 reach_of(const Shape& shape, const Body& body, double turning_path, double margin) {
    if (const auto* sphere = std::get_if<Sphere>(&shape)) return Vector3::Constant(sphere->radius);
    const Vector3& half = std::get<Box>(shape).half_size;
    const double room = margin * size_of(shape);
    if (turning_path > room) return Vector3::Constant(half.norm());
    return pose_of(body).rotation.cwiseAbs() * half + Vector3::Constant(room);
}

}  // namespace

double path_of(const Collider& collider, double speed, double rate, double dt) {
    const auto* box = std::get_if<Box>(&collider.shape);
    return dt * (speed + (box ? rate * box->half_size.norm() : 0.0));  // a sphere turns in itself
}

std::span<const Pair> FastPairs::find(const Outlook& outlook, const std::vector<bool>& fast) {
    boxes_.clear();
    box_bodies_.clear();
    for (std::size_t i = 0; i < outlook.colliders.size(); ++i) {
        const Collider& collider = outlook.colliders[i];
        const Body& body = outlook.bodies[static_cast<std::size_t>(collider.body)];
        const Motion& motion = outlook.motions[static_cast<std::size_t>(collider.body)];
        Body& swept = box_bodies_.emplace_back(body);
        boxes_.push_back({.body = static_cast<int>(i), .shape = collider.shape});
        if (std::holds_alternative<Plane>(collider.shape)) continue;
        const Vector3 path = outlook.dt * motion.velocity;
        const double turning_path = path_of(collider, 0.0, motion.angular_velocity.norm(), outlook.dt);
        swept.position += 0.5 * path;
        swept.orientation.setIdentity();
        boxes_.back().shape =
            Box{reach_of(collider.shape, body, turning_path, outlook.margin) + 0.5 * path.cwiseAbs()};
    }
    box_poses_.clear();
    for (const Body& body : box_bodies_) box_poses_.push_back(pose_of(body));
    pairs_.clear();
    for (const Pair& pair : broad_phase_.find_pairs(boxes_, box_bodies_, box_poses_, 0.0)) {
        const auto a = static_cast<std::size_t>(pair.a);
        const auto b = static_cast<std::size_t>(pair.b);
        const bool same_body = outlook.colliders[a].body == outlook.colliders[b].body;
        if ((fast[a] || fast[b]) && !same_body) pairs_.push_back(pair);
    }
    return pairs_;
}

}  // namespace pushfactor::engine::collision
