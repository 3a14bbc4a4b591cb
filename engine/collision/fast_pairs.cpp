#include "engine/collision/fast_pairs.h"

#include <cmath>
#include <limits>

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

// The farthest point of a finite shape from its centre [m].
double radius_of(const Shape& shape) {
    if (const auto* sphere = std::get_if<Sphere>(&shape)) return sphere->radius;
    return std::get<Box>(shape).half_size.norm();
}

const Body& body_of(const Outlook& outlook, std::size_t collider) {
    return outlook.bodies[static_cast<std::size_t>(outlook.colliders[collider].body)];
}

Vector6 constraint_force_on(const Outlook& outlook, std::size_t collider) {
    if (outlook.constraint_forces.empty()) return Vector6::Zero();
    return outlook.constraint_forces[static_cast<std::size_t>(outlook.colliders[collider].body)];
}

bool is_plane(const Outlook& outlook, std::size_t collider) {
    return std::holds_alternative<Plane>(outlook.colliders[collider].shape);
}

}  // namespace

// Writes how the collider moves, and what through.
void FastPairs::sweep(const Outlook& outlook, std::size_t collider) {
    const Body& body = body_of(outlook, collider);
    Swept& swept = swept_[collider];
    swept.motion = engine::motion_of(body, outlook.dt, constraint_force_on(outlook, collider));
    if (is_plane(outlook, collider)) return;
    const Collider& which = outlook.colliders[collider];
    const Vector3 path = outlook.dt * swept.motion.velocity;
    const double turning_path = path_of(which, 0.0, swept.motion.angular_velocity.norm(), outlook.dt);
    swept.box.centre = body.position + 0.5 * path;
    swept.box.reach = reach_of(which.shape, body, turning_path, outlook.margin) + 0.5 * path.cwiseAbs();
}

FastPairs::Region FastPairs::region_of_fast(const Outlook& outlook, const std::vector<bool>& fast) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Region region{Vector3::Constant(infinity), Vector3::Constant(-infinity)};
    for (std::size_t i = 0; i < fast.size(); ++i) {
        if (!fast[i]) continue;
        sweep(outlook, i);
        if (is_plane(outlook, i)) continue;
        region.low = region.low.cwiseMin(swept_[i].box.centre - swept_[i].box.reach);
        region.high = region.high.cwiseMax(swept_[i].box.centre + swept_[i].box.reach);
    }
    return region;
}

// Whether a collider that is not fast may come into the region, by the longest way that it can go.
bool FastPairs::may_reach(const Region& region, const Outlook& outlook, std::size_t collider) const {
    if (is_plane(outlook, collider)) return true;
    const Body& body = body_of(outlook, collider);
    const Collider& which = outlook.colliders[collider];
    const auto on = static_cast<std::size_t>(which.body);
    double squared = 0.0;  // of the momentum at the end of the step
    for (int axis = 0; axis < 3; ++axis) {
        const double constraint = outlook.constraint_forces.empty() ? 0.0 : outlook.constraint_forces[on][axis];
        const double momentum = body.linear_momentum[axis] + outlook.dt * (body.force[axis] + constraint);
        squared += momentum * momentum;
    }
    const double path = outlook.dt * body.inverse_mass * std::sqrt(squared);
    const double reach = radius_of(which.shape) + outlook.margin * size_of(which.shape) + path;
    // Written so that what is not finite is looked at.
    const auto beyond = [&](int axis) {
        return body.position[axis] - reach > region.high[axis] || body.position[axis] + reach < region.low[axis];
    };
    return !(beyond(0) || beyond(1) || beyond(2));
}

void FastPairs::add(const Outlook& outlook, std::size_t collider) {
    const int place = static_cast<int>(chosen_.size());
    chosen_.push_back(static_cast<int>(collider));
    const Collider& which = outlook.colliders[collider];
    const Body& body = body_of(outlook, collider);
    Body& box_body = box_bodies_.emplace_back();
    box_body.inverse_mass = body.inverse_mass;
    boxes_.push_back({.body = place, .shape = which.shape});
    if (is_plane(outlook, collider)) {
        box_poses_.push_back(pose_of(body));
        return;
    }
    boxes_.back().shape = Box{swept_[collider].box.reach};
    box_poses_.push_back({swept_[collider].box.centre, Matrix3::Identity()});
}

std::span<const Pair> FastPairs::find(const Outlook& outlook, const std::vector<bool>& fast) {
    chosen_.clear();
    boxes_.clear();
    box_bodies_.clear();
    box_poses_.clear();
    swept_.resize(fast.size());
    const Region region = region_of_fast(outlook, fast);
    for (std::size_t i = 0; i < fast.size(); ++i) {
        if (!fast[i] && !may_reach(region, outlook, i)) continue;
        if (!fast[i]) sweep(outlook, i);
        add(outlook, i);
    }
    pairs_.clear();
    for (const Pair& pair : broad_phase_.find_pairs(boxes_, box_bodies_, box_poses_, 0.0)) {
        const int a = chosen_[static_cast<std::size_t>(pair.a)], b = chosen_[static_cast<std::size_t>(pair.b)];
        const bool any_fast = fast[static_cast<std::size_t>(a)] || fast[static_cast<std::size_t>(b)];
        const bool same_body = outlook.colliders[static_cast<std::size_t>(a)].body ==
                               outlook.colliders[static_cast<std::size_t>(b)].body;
        if (any_fast && !same_body) pairs_.push_back({a, b});
    }
    return pairs_;
}

}  // namespace pushfactor::engine::collision
