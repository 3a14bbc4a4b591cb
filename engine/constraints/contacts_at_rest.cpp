// What contacts need for bodies at rest: which take part in a step, and which wake.
#include "engine/constraints/contact_constraints.h"

#include <algorithm>
#include <iterator>

namespace pushfactor::engine {

namespace {

// The members of both, ascending.
std::vector<int> united(std::span<const int> members, std::vector<int> others) {
    std::sort(others.begin(), others.end());
    std::vector<int> all;
    std::set_union(members.begin(), members.end(), others.begin(), others.end(), std::back_inserter(all));
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

}  // namespace

void ContactConstraints::wake_all(std::size_t bodies) {
    awake_bodies_ = Awake(bodies);
    awake_colliders_ = Awake(colliders_.size());
    colliders_of_.assign(bodies, {});
    for (std::size_t i = 0; i < colliders_.size(); ++i) {
        colliders_of_[static_cast<std::size_t>(colliders_[i].body)].push_back(static_cast<int>(i));
    }
}

void ContactConstraints::leave_out_others(std::span<const Body> bodies, const Awake& awake,
                                          std::span<const int> changed) {
    if (awake_bodies_.of() != bodies.size()) wake_all(bodies.size());
    std::vector<int> colliders;
    for (const int body : changed) {
        const std::vector<int>& own = colliders_of_[static_cast<std::size_t>(body)];
        colliders.insert(colliders.end(), own.begin(), own.end());
    }
    const auto body_of = [&](int collider) { return colliders_[static_cast<std::size_t>(collider)].body; };
    awake_bodies_.update(changed, [&](int body) { return awake.has(body); });
    awake_colliders_.update(colliders, [&](int collider) { return awake.has(body_of(collider)); });
    moved_bodies_ = united(awake_bodies_.members(), {changed.begin(), changed.end()});
    moved_colliders_ = united(awake_colliders_.members(), colliders);
    if (!cache_) return;
    const auto moves = [&](const collision::Pair& pair) {
        return is_any_moving(bodies, awake, body_of(pair.a), body_of(pair.b));
    };
    ContactCache moving;
    ContactCache::each_of_both(*cache_, at_rest_.take(colliders, moves), [&](const auto& pair, const auto& points) {
        if (moves(pair)) {
            moving.add(pair, points);
        } else {
            at_rest_.add(pair, points);
        }
    });
    *cache_ = std::move(moving);
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
    if (!belts_start_) return changed;
    if (!cache_) {  // without a cache the bodies on the belt are unknown
        for (int i = 0; i < static_cast<int>(colliders_.size()) && !changed.all; ++i) changed.all = begins(i);
        return changed;
    }
    at_rest_.each([&](const collision::Pair& pair, const auto&) {
        if (!begins(pair.a) && !begins(pair.b)) return;
        for (const int collider : {pair.a, pair.b}) {
            changed.some.push_back(colliders_[static_cast<std::size_t>(collider)].body);
        }
    });
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
    at_rest_.each([&](const collision::Pair& pair, std::span<const ContactCache::Point> points) {
        collision::Manifold manifold;
        collision::Touch touch;
        if (!collision::find_touch(pair, scene, manifold, touch)) return;
        for (const ContactCache::Point& point : points) {
            const double normal = point.force.normal.last;
            found.push_back({.site = {.body_a = touch.body_a,
                                      .body_b = touch.body_b,
                                      .position = point.position,
                                      .normal = touch.normal},
                             .normal = normal,
                             .force = touch.normal * normal + point.force.friction_last});
        }
    });
    return found;
}

void ContactConstraints::set_forces(const ContactCache& all) {
    if (cache_) *cache_ = all;
    at_rest_ = {};
    awake_bodies_ = {};
}

void ContactConstraints::all_forces(ContactCache& into) const {
    into.clear();
    if (!cache_) return;
    ContactCache at_rest;
    at_rest_.each([&](const collision::Pair& pair, const auto& points) { at_rest.add(pair, points); });
    ContactCache::each_of_both(*cache_, at_rest,
                               [&](const collision::Pair& pair, const auto& points) { into.add(pair, points); });
}

}  // namespace pushfactor::engine
