#include "engine/collision/sweep.h"

#include <algorithm>

namespace pushfactor::engine::collision {

namespace {

// How near two bodies have to come for having met, as a fraction of the size.
constexpr double nearness = 1e-4;

double smallest_gap(const Manifold& manifold) {
    double gap = std::numeric_limits<double>::infinity();
    for (const ContactPoint& point : manifold.points()) gap = std::min(gap, point.gap);
    return gap;
}

// Whether the free motion may take a touching pair beyond what its manifold knows: into contact by a way that the
// margin's normal does not foresee, or with corners that the margin does not reach.
bool has_more(const Touch& touch, const Moving& a, const Moving& b, double dt, double margin) {
    const double gap = smallest_gap(touch.manifold);
    return approach(a, b, touch.manifold.normal, dt) > (gap > 0.0 ? gap : margin);
}

Vector3 velocity_at(const Motion& motion, const Vector3& arm) {
    return motion.velocity + motion.angular_velocity.cross(arm);
}

// From the gaps at the meeting to those that the motion so far has been closing. A point that was opening meanwhile
// keeps its gap, which leaves it more room than it has, but never pushes it.
void wind_back(Meeting& meeting, const Moving& a, const Moving& b) {
    for (ContactPoint& point : std::span(meeting.manifold.storage.data(), meeting.manifold.points().size())) {
        const Vector3 closing = velocity_at(a.motion, point.position - meeting.pose_a.position) -
                                velocity_at(b.motion, point.position - meeting.pose_b.position);
        point.gap = std::max(0.0, point.gap + meeting.time * closing.dot(meeting.manifold.normal));
    }
}

// The body with its momenta as they are, where its centre will be.
Body moved_to(const Body& body, const Pose& pose) {
    Body moved = body;
    moved.position = pose.position;
    return moved;
}

}  // namespace

void Sweep::refine_pair(const Pair& pair, const Touch* touch, std::span<const Collider> colliders,
                        std::span<const Body> bodies, double dt, const Detection& detection) {
    const auto moving = [&](int index) -> Moving {
        const Collider& collider = colliders[static_cast<std::size_t>(index)];
        const Body& body = bodies[static_cast<std::size_t>(collider.body)];
        return {collider.shape, pose_of(body), body.is_static() ? Motion{} : free_motion(body, dt)};
    };
    const Moving a = moving(pair.a);
    const Moving b = moving(pair.b);
    Touch swept = touch_of(pair, colliders, bodies);
    const double margin = detection.margin * swept.size;
    if (touch && !has_more(*touch, a, b, dt, margin)) {
        touches_.push_back(*touch);
        return;
    }
    std::optional<Meeting> meeting = find_meeting(a, b, dt, nearness * swept.size, margin);
    if (!meeting) return;
    if (meeting->time > 0.0) {
        wind_back(*meeting, a, b);
        swept.meeting = &bodies_.emplace_back(
            MeetingBodies{moved_to(bodies[static_cast<std::size_t>(swept.body_a)], meeting->pose_a),
                          moved_to(bodies[static_cast<std::size_t>(swept.body_b)], meeting->pose_b)});
    }
    swept.manifold = meeting->manifold;
    if (detection.reduce_to_four_points) reduce_to_four(swept.manifold, a.start.rotation);
    touches_.push_back(swept);
}

std::span<const Touch> Sweep::refine(std::span<const Touch> touches, std::span<const Collider> colliders,
                                     std::span<const Body> bodies, double dt, const Detection& detection) {
    const std::span<const Pair> pairs = fast_pairs_.find(colliders, bodies, dt, detection.margin);
    if (pairs.empty()) return touches;
    touches_.clear();
    bodies_.clear();
    auto touch = touches.begin();
    for (const Pair& pair : pairs) {
        for (; touch != touches.end() && touch->pair < pair; ++touch) touches_.push_back(*touch);
        const bool touching = touch != touches.end() && touch->pair == pair;
        refine_pair(pair, touching ? &*touch : nullptr, colliders, bodies, dt, detection);
        if (touching) ++touch;
    }
    touches_.insert(touches_.end(), touch, touches.end());
    return touches_;
}

}  // namespace pushfactor::engine::collision
