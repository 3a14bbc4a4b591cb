#include "engine/collision/fast_pairs.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace pushfactor::engine::collision {

namespace {

// Half the edges of a box around the shape, however it turns within the step [m].
Vector3 reach_of(const Shape& shape, const Body& body, double turning_path, double margin) {
    const Matrix3 rotation = pose_of(body).rotation;
    if (turns_in_itself(shape)) return half_extents(shape, rotation);
    const double room = margin * size_of(shape);
    if (turning_path > room) return Vector3::Constant(std::sqrt(squared_turning_radius(shape)));
    return half_extents(shape, rotation) + Vector3::Constant(room);
}

const Body& body_of(const Outlook& outlook, std::size_t collider) {
    return outlook.bodies[static_cast<std::size_t>(outlook.colliders[collider].body)];
}

Vector6 constraint_force_on(const Outlook& outlook, std::size_t collider) {
    if (outlook.constraint_forces.empty()) return Vector6::Zero();
    return outlook.constraint_forces[static_cast<std::size_t>(outlook.colliders[collider].body)];
}

bool is_plane(const Outlook& outlook, std::size_t collider) {
    return !is_finite(outlook.colliders[collider].shape);
}

}  // namespace

// How the collider moves, and what through.
const FastPairs::Swept& FastPairs::sweep(const Outlook& outlook, int collider) {
    const auto index = static_cast<std::size_t>(collider);
    Swept& swept = swept_[index];
    if (swept.search == search_) return swept;
    swept.search = search_;
    const Body& body = body_of(outlook, index);
    swept.motion = engine::motion_of(body, outlook.dt, constraint_force_on(outlook, index));
    if (is_plane(outlook, index)) return swept;
    const Collider& which = outlook.colliders[index];
    const Vector3 path = outlook.dt * swept.motion.velocity;
    const double turning_path = path_of(which, 0.0, swept.motion.angular_velocity.norm(), outlook.dt);
    swept.box.centre = body.position + 0.5 * path;
    swept.box.reach = reach_of(which.shape, body, turning_path, outlook.margin) + 0.5 * path.cwiseAbs();
    return swept;
}

void FastPairs::begin(std::size_t colliders) {
    ++step_;
    fast_in_.resize(colliders);
    swept_.resize(colliders);
}

std::span<const Pair> FastPairs::find(const Outlook& outlook, std::span<const int> awake,
                                      const std::vector<bool>& fast, BroadPhase& broad_phase) {
    ++search_;
    for (const int collider : awake) {
        const auto i = static_cast<std::size_t>(collider);
        if (fast[i]) fast_in_[i] = step_;
        if (fast_in_[i] != step_ || is_plane(outlook, i)) continue;
        broad_phase.put(collider, sweep(outlook, collider).box);
    }
    pairs_.clear();
    for (const Pair& pair : broad_phase.find_pairs_of(fast)) {
        const Swept& a = sweep(outlook, pair.a);
        const Swept& b = sweep(outlook, pair.b);
        const bool any_plane = is_plane(outlook, static_cast<std::size_t>(pair.a)) ||
                               is_plane(outlook, static_cast<std::size_t>(pair.b));
        if (any_plane || overlap(a.box, b.box)) pairs_.push_back(pair);
    }
    return pairs_;
}

std::span<const Pair> FastPairs::find(const Outlook& outlook, std::span<const int> awake,
                                      const std::vector<bool>& fast, std::span<const Pair> more,
                                      BroadPhase& broad_phase) {
    const std::span<const Pair> found = find(outlook, awake, fast, broad_phase);
    if (more.empty()) return found;
    for (const Pair& pair : more) {
        sweep(outlook, pair.a);
        sweep(outlook, pair.b);
    }
    merged_.clear();
    std::set_union(found.begin(), found.end(), more.begin(), more.end(), std::back_inserter(merged_));
    return merged_;
}

}  // namespace pushfactor::engine::collision
