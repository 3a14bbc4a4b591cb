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

// How fast the bodies close the gap at `point` of their meeting, m/s.
double closing_speed(const Meeting& meeting, const Moving& a, const Moving& b, const Vector3& point) {
    const auto velocity = [&point](const Motion& motion, const Pose& pose) -> Vector3 {
        return motion.velocity + motion.angular_velocity.cross(point - pose.position);
    };
    const Vector3 relative = velocity(a.motion, meeting.pose_a) - velocity(b.motion, meeting.pose_b);
    return relative.dot(meeting.manifold.normal);
}

// What is thrown back is so at the points that meet of themselves. One that only the throw brings down would be
// stopped in this step; left out, it is thrown back in its turn.
void keep_meeting_points(Meeting& meeting, const Moving& a, const Moving& b, double rest) {
    Manifold kept;
    kept.normal = meeting.manifold.normal;
    for (const ContactPoint& point : meeting.manifold.points()) {
        if (point.gap < rest * closing_speed(meeting, a, b, point.position)) kept.add(point);
    }
    if (kept.count > 0) meeting.manifold = kept;
}

// From the gaps at the meeting to those that the motion so far has been closing. A point that was opening meanwhile
// keeps its gap, which leaves it more room than it has, but never pushes it.
void wind_back(Meeting& meeting, const Moving& a, const Moving& b) {
    for (int i = 0; i < meeting.manifold.count; ++i) {
        ContactPoint& point = meeting.manifold.storage[static_cast<std::size_t>(i)];
        point.gap = std::max(0.0, point.gap + meeting.time * closing_speed(meeting, a, b, point.position));
    }
}

// The body with its momenta as they are, where its centre will be.
Body moved_to(const Body& body, const Pose& pose) {
    Body moved = body;
    moved.position = pose.position;
    return moved;
}

}  // namespace

void Sweep::refine_pair(const Pair& pair, const Touch* touch, const Step& step) {
    const Moving& a = moving_[static_cast<std::size_t>(pair.a)];
    const Moving& b = moving_[static_cast<std::size_t>(pair.b)];
    Touch swept = touch_of(pair, step.colliders, step.bodies);
    const double margin = step.detection.margin * swept.size;
    if (touch && !has_more(*touch, a, b, step.dt, margin)) {
        touches_.push_back(*touch);
        return;
    }
    std::optional<Meeting> meeting = find_meeting(a, b, step.dt, nearness * swept.size, margin);
    if (!meeting) return;
    if (swept.restitution > 0.0) keep_meeting_points(*meeting, a, b, step.dt - meeting->time);
    if (meeting->time > 0.0) {
        wind_back(*meeting, a, b);
        const Body& body_a = step.bodies[static_cast<std::size_t>(swept.body_a)];
        const Body& body_b = step.bodies[static_cast<std::size_t>(swept.body_b)];
        meetings_.push_back({moved_to(body_a, meeting->pose_a), moved_to(body_b, meeting->pose_b)});
        swept.meeting = &meetings_.back();
    }
    swept.manifold = meeting->manifold;
    if (step.detection.reduce_to_four_points) reduce_to_four(swept.manifold, a.start.rotation);
    touches_.push_back(swept);
}

std::span<const Touch> Sweep::refine(std::span<const Touch> touches, const Step& step) {
    const std::span<const Pair> pairs =
        fast_pairs_.find(step.colliders, step.bodies, step.dt, step.detection.margin);
    if (pairs.empty()) return touches;
    moving_.clear();
    for (const Collider& collider : step.colliders) {
        const Body& body = step.bodies[static_cast<std::size_t>(collider.body)];
        moving_.push_back({collider.shape, pose_of(body), free_motion(body, step.dt)});
    }
    touches_.clear();
    meetings_.clear();
    auto touch = touches.begin();
    for (const Pair& pair : pairs) {
        for (; touch != touches.end() && touch->pair < pair; ++touch) touches_.push_back(*touch);
        const bool touching = touch != touches.end() && touch->pair == pair;
        refine_pair(pair, touching ? &*touch : nullptr, step);
        if (touching) ++touch;
    }
    touches_.insert(touches_.end(), touch, touches.end());
    return touches_;
}

}  // namespace pushfactor::engine::collision
