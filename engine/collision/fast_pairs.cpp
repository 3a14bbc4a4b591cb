#include "engine/collision/fast_pairs.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine::collision {

namespace {

// How far turning takes the farthest point of the shape, at most [m]. The largest inverse moment bounds the rate.
double turning_path(const Shape& shape, const Body& body, double dt) {
    const auto* box = std::get_if<Box>(&shape);
    if (!box) return 0.0;
    return body.angular_momentum.norm() * body.inverse_inertia.maxCoeff() * box->half_size.norm() * dt;
}

// By the velocities before the step: what rests on something is not fast because of its weight.
bool is_fast(const Collider& collider, const Body& body, double dt, double margin) {
    if (body.is_static()) return false;
    const double path = velocity(body).norm() * dt + turning_path(collider.shape, body, dt);
    return path > margin * size_of(collider.shape);
}

// Half the edges of a box around the shape, however it turns within the step when it is fast [m].
Vector3 reach_of(const Shape& shape, const Body& body, bool fast, double margin) {
    if (const auto* sphere = std::get_if<Sphere>(&shape)) return Vector3::Constant(sphere->radius);
    const Vector3& half = std::get<Box>(shape).half_size;
    if (fast && !body.angular_momentum.isZero(0.0)) return Vector3::Constant(half.norm());
    return pose_of(body).rotation.cwiseAbs() * half + Vector3::Constant(2.0 * margin * half.minCoeff());
}

}  // namespace

Motion free_motion(const Body& body, double dt) {
    if (body.is_static()) return {};
    const Vector3 spin_up = world_inverse_inertia(body) * body.torque;
    return {velocity(body) + (dt * body.inverse_mass) * body.force, angular_velocity(body) + dt * spin_up};
}

std::span<const Pair> FastPairs::find(std::span<const Collider> colliders, std::span<const Body> bodies, double dt,
                                      double margin) {
    const auto body_of = [&](const Collider& c) -> const Body& { return bodies[static_cast<std::size_t>(c.body)]; };
    pairs_.clear();
    fast_.clear();
    for (const Collider& c : colliders) fast_.push_back(is_fast(c, body_of(c), dt, margin));
    if (std::find(fast_.begin(), fast_.end(), true) == fast_.end()) return pairs_;

    boxes_.clear();
    box_bodies_.clear();
    for (std::size_t i = 0; i < colliders.size(); ++i) {
        const Body& body = body_of(colliders[i]);
        Body& swept = box_bodies_.emplace_back(body);
        boxes_.push_back({.body = static_cast<int>(i), .shape = colliders[i].shape});
        if (std::holds_alternative<Plane>(colliders[i].shape)) continue;
        const Vector3 path = dt * free_motion(body, dt).velocity;
        swept.position += 0.5 * path;
        swept.orientation.setIdentity();
        boxes_.back().shape = Box{reach_of(colliders[i].shape, body, fast_[i], margin) + 0.5 * path.cwiseAbs()};
    }
    for (const Pair& pair : broad_phase_.find_pairs(boxes_, box_bodies_, 0.0)) {
        const auto a = static_cast<std::size_t>(pair.a);
        const auto b = static_cast<std::size_t>(pair.b);
        if ((fast_[a] || fast_[b]) && colliders[a].body != colliders[b].body) pairs_.push_back(pair);
    }
    return pairs_;
}

}  // namespace pushfactor::engine::collision
