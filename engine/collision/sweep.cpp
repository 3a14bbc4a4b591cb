#include "engine/collision/sweep.h"

#include <algorithm>

namespace pushfactor::engine::collision {

namespace {

double margin_of(const Collider& collider, const Sweep::Step& step) {
    return step.detection.margin * size_of(collider.shape);
}

// By the velocities before the step: what rests on something is not fast because of its weight. The largest inverse
// moment bounds the rate of turning.
bool is_fast(const Collider& collider, const Body& body, const Sweep::Step& step) {
    const double rate = body.angular_momentum.norm() * body.inverse_inertia.maxCoeff();
    return path_of(collider, velocity(body).norm(), rate, step.dt) > margin_of(collider, step);
}

// Whether the constraint force makes the body move otherwise than foreseen, by more than its margin, and fast.
bool is_thrown(const Collider& collider, const Body& body, const Vector6& force, const Sweep::Step& step) {
    const double speed = step.dt * body.inverse_mass * force.head<3>().norm();
    const double rate = step.dt * body.inverse_inertia.maxCoeff() * force.tail<3>().norm();
    const double margin = margin_of(collider, step);
    if (path_of(collider, speed, rate, step.dt) <= margin) return false;
    const Motion motion = motion_of(body, step.dt, force);
    return path_of(collider, motion.velocity.norm(), motion.angular_velocity.norm(), step.dt) > margin;
}

// How near two bodies have to come for having met, as a fraction of the size.
constexpr double nearness = 1e-4;

bool before(const Touch& touch, const Pair& pair) {
    return touch.pair < pair;
}

double smallest_gap(std::span<const ContactPoint> points) {
    double gap = std::numeric_limits<double>::infinity();
    for (const ContactPoint& point : points) gap = std::min(gap, point.gap);
    return gap;
}

// Whether the free motion may take a touching pair beyond what its manifold knows: into contact by a way that the
// margin's normal does not foresee, or with corners that the margin does not reach.
bool has_more(const Touch& touch, const Moving& a, const Moving& b, double dt, double margin) {
    const double gap = smallest_gap(touch.points);
    return approach(a, b, touch.normal, dt) > (gap > 0.0 ? gap : margin);
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

Moving Sweep::moving(int collider, const Step& step) const {
    const Collider& which = step.colliders[static_cast<std::size_t>(collider)];
    const auto body = static_cast<std::size_t>(which.body);
    return {which.shape, pose_of(step.bodies[body]), fast_pairs_.motion_of(collider)};
}

bool Sweep::any_fast(const Step& step) {
    fast_.clear();
    bool any = false;
    for (const Collider& collider : step.colliders) {
        fast_.push_back(is_fast(collider, step.bodies[static_cast<std::size_t>(collider.body)], step));
        any = any || fast_.back();
    }
    return any;
}

bool Sweep::any_thrown(std::span<const Vector6> forces, std::span<const char> changed, const Step& step) {
    fast_.clear();
    bool any = false;
    for (const Collider& collider : step.colliders) {
        const auto body = static_cast<std::size_t>(collider.body);
        fast_.push_back(changed[body] && is_thrown(collider, step.bodies[body], forces[body], step));
        any = any || fast_.back();
    }
    return any;
}

// Adds the touch of a pair that meets, with the motions of the moment.
bool Sweep::add_meeting(const Pair& pair, const Step& step, std::vector<Touch>& touches) {
    const Moving a = moving(pair.a, step);
    const Moving b = moving(pair.b, step);
    Touch touch;
    name_pair(pair, step.colliders, step.bodies, touch);
    combine_surfaces(step.colliders, touch);
    const double margin = step.detection.margin * touch.size;
    std::optional<Meeting> meeting = find_meeting(a, b, step.dt, nearness * touch.size, margin);
    if (!meeting) return false;
    if (touch.restitution > 0.0) keep_meeting_points(*meeting, a, b, step.dt - meeting->time);
    if (meeting->time > 0.0) {
        wind_back(*meeting, a, b);
        const Body& body_a = step.bodies[static_cast<std::size_t>(touch.body_a)];
        const Body& body_b = step.bodies[static_cast<std::size_t>(touch.body_b)];
        found_.bodies.push_back({moved_to(body_a, meeting->pose_a), moved_to(body_b, meeting->pose_b)});
        touch.meeting = &found_.bodies.back();
    }
    Manifold& manifold = meeting->manifold;
    if (step.detection.reduce_to_four_points) reduce_to_four(manifold, a.start.rotation);
    touch.normal = manifold.normal;
    touch.points = found_.keep(manifold.points());
    touches.push_back(touch);
    return true;
}

void Sweep::refine_fast(std::span<const Touch> touches, const Step& step) {
    auto touch = touches.begin();
    const Outlook outlook{step.colliders, step.bodies, {}, step.dt, step.detection.margin};
    for (const Pair& pair : fast_pairs_.find(outlook, fast_)) {
        for (; touch != touches.end() && touch->pair < pair; ++touch) refined_.push_back(*touch);
        const bool touching = touch != touches.end() && touch->pair == pair;
        const double margin = touching ? step.detection.margin * touch->size : 0.0;
        if (touching && !has_more(*touch, moving(pair.a, step), moving(pair.b, step), step.dt, margin)) {
            refined_.push_back(*touch);
        } else {
            add_meeting(pair, step, refined_);
        }
        if (touching) ++touch;
    }
    refined_.insert(refined_.end(), touch, touches.end());
}

std::span<const Touch> Sweep::refine(std::span<const Touch> touches, const Step& step) {
    found_.clear();
    seen_.clear();
    known_ = touches;
    if (!any_fast(step)) return known_;
    refined_.clear();
    refine_fast(touches, step);
    known_ = refined_;
    return known_;
}

bool Sweep::is_known(const Pair& pair) const {
    const auto known = std::lower_bound(known_.begin(), known_.end(), pair, before);
    if (known != known_.end() && known->pair == pair) return true;
    return std::binary_search(seen_.begin(), seen_.end(), pair);
}

std::span<const Touch> Sweep::look(std::span<const Vector6> forces, std::span<const char> changed,
                                   const Step& step) {
    unforeseen_.clear();
    if (!any_thrown(forces, changed, step)) return unforeseen_;
    const Outlook outlook{step.colliders, step.bodies, forces, step.dt, step.detection.margin};
    for (const Pair& pair : fast_pairs_.find(outlook, fast_)) {
        if (!is_known(pair)) add_meeting(pair, step, unforeseen_);
    }
    const auto middle = static_cast<std::ptrdiff_t>(seen_.size());
    for (const Touch& touch : unforeseen_) seen_.push_back(touch.pair);
    std::inplace_merge(seen_.begin(), seen_.begin() + middle, seen_.end());
    return unforeseen_;
}

}  // namespace pushfactor::engine::collision
