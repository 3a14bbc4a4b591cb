// What contacts need for bodies at rest: which take part in a step, and which wake.
#include "engine/constraints/contact_constraints.h"

#include <algorithm>

namespace pushfactor::engine {

// Default until leave_out_others() is called.
void ContactConstraints::wake_all(std::size_t bodies) {
    all_bodies_ = awake_bodies_ = Awake(bodies);
    all_colliders_ = awake_colliders_ = Awake(colliders_.size());
    awake_anew_ = true;
}

void ContactConstraints::leave_out_others(std::span<const Body> bodies, const Awake& awake) {
    wake_all(bodies.size());
    awake_bodies_ = awake;
    std::vector<char> is_awake;
    for (const collision::Collider& collider : colliders_) is_awake.push_back(awake.has(collider.body));
    awake_colliders_ = Awake(std::move(is_awake));
    if (!cache_) return;
    const auto moves = [&](const collision::Pair& pair) {
        const auto body_of = [&](int collider) { return colliders_[static_cast<std::size_t>(collider)].body; };
        return is_any_moving(bodies, awake, body_of(pair.a), body_of(pair.b));
    };
    cache_->take_from(at_rest_, moves);
    at_rest_.take_from(*cache_, [&](const collision::Pair& pair) { return !moves(pair); });
}

bool ContactConstraints::turns_unseen(int body) const {
    return std::none_of(colliders_.begin(), colliders_.end(), [body](const collision::Collider& collider) {
        return collider.body == body && !collision::turns_in_itself(collider.shape);
    });
}

// Resting bodies on a belt that starts to run.
SomeBodies ContactConstraints::changed_anew(double from, double until) const {
    SomeBodies changed;
    const auto begins = [&](int collider) {
        const collision::Collider& own = colliders_[static_cast<std::size_t>(collider)];
        return collision::runs_at(own, from) != collision::runs_at(own, until);
    };
    if (std::none_of(colliders_.begin(), colliders_.end(),
                     [](const auto& own) { return own.surface_from > 0.0; })) {
        return changed;
    }
    if (!cache_) {  // without a cache the bodies on the belt are unknown
        for (int i = 0; i < static_cast<int>(colliders_.size()) && !changed.all; ++i) changed.all = begins(i);
        return changed;
    }
    for (const ContactCache::Entry& entry : at_rest_.entries()) {
        if (!begins(entry.pair.a) && !begins(entry.pair.b)) continue;
        for (const int collider : {entry.pair.a, entry.pair.b}) {
            changed.some.push_back(colliders_[static_cast<std::size_t>(collider)].body);
        }
    }
    return changed;
}

// Those within the margin of its way. A plane that turns may meet all; one that moves is where it ends.
SomeBodies ContactConstraints::met_by_moved(const StepStart& step) const {
    SomeBodies met;
    const bool is_known = awake_bodies_.of() == step.bodies.size();  // not before the first step
    for (const collision::Collider& own : colliders_) {
        const Body& moved = step.bodies[static_cast<std::size_t>(own.body)];
        if (!moved.is_moved()) continue;
        const collision::Pose pose = collision::pose_of(moved);
        const Motion& motion = moved.prescribed;
        const bool is_plane = !is_finite(own.shape);
        const auto meets = [&](const collision::BoundingBox& box) {
            if (!is_plane) return overlap(box, swept_box(own.shape, pose, motion, step.dt, 0.0));
            const Vector3 up = pose.rotation.col(1), end = pose.position + step.dt * motion.velocity;
            if (!motion.angular_velocity.isZero(0.0)) return true;
            return std::min(up.dot(box.centre - pose.position), up.dot(box.centre - end)) <
                   up.cwiseAbs().dot(box.reach);
        };
        for (const collision::Collider& other : colliders_) {
            if ((is_known && awake_bodies_.has(other.body)) || !is_finite(other.shape)) continue;
            const Body& resting = step.bodies[static_cast<std::size_t>(other.body)];
            const double margin = choices_.detection.margin * size_of(other.shape);
            const auto box = swept_box(other.shape, collision::pose_of(resting), {}, 0.0, margin);
            if (meets(box)) met.some.push_back(other.body);
        }
    }
    return met;
}

// Their points are remembered with the forces; the normal is that of the places where they rest.
std::vector<RestingContact> ContactConstraints::sites_at_rest(std::span<const Body> bodies) const {
    std::vector<RestingContact> found;
    const collision::StepScene scene{colliders_, bodies, detector_.poses(), choices_.detection};
    for (const ContactCache::Entry& entry : at_rest_.entries()) {
        collision::Manifold manifold;
        collision::Touch touch;
        if (!collision::find_touch(entry.pair, scene, manifold, touch)) continue;
        for (const ContactCache::Point& point : at_rest_.of(entry)) {
            const double normal = point.force.normal.last;
            found.push_back({.site = {.body_a = touch.body_a,
                                      .body_b = touch.body_b,
                                      .position = point.position,
                                      .normal = touch.normal},
                             .normal = normal,
                             .force = touch.normal * normal + point.force.friction_last});
        }
    }
    return found;
}

void ContactConstraints::all_forces(ContactCache& into) const {
    into = cache_ ? *cache_ : ContactCache{};
    if (at_rest_.entries().empty()) return;
    ContactCache at_rest = at_rest_;
    into.take_from(at_rest, [](const collision::Pair&) { return true; });
}

}  // namespace pushfactor::engine
