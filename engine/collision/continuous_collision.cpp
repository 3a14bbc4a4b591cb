#include "engine/collision/continuous_collision.h"

#include "engine/collision/pairs/pair_table.h"

#include <algorithm>

namespace pushfactor::engine::collision {

namespace {

double margin_of(const Collider& collider, const ContinuousCollision::Step& step) {
    return step.detection.margin * size_of(collider.shape);
}

// Path by the velocities before the step: a resting body is not fast because of its weight. The largest inverse
// moment bounds the angular velocity.
double free_path(const Collider& collider, const Body& body, const ContinuousCollision::Step& step) {
    const double rate = body.angular_momentum.norm() * body.inverse_inertia.maxCoeff();
    return path_of(collider, velocity(body).norm(), rate, step.dt);
}

// Whether the external forces of the step make the path of the collider dangerous.
bool is_pressed(const Collider& collider, const Body& body, const Vector3& velocity,
                const ContinuousCollision::Step& step) {
    const double rate = (body.angular_momentum + step.dt * body.torque).norm() * body.inverse_inertia.maxCoeff();
    return path_of(collider, velocity.norm(), rate, step.dt) > dangerous * size_of(collider.shape);
}

// Conservative pre-test for is_pressed(): false is certain. `path` [m] is the path by the velocity alone. Uses
// squares, because it runs for every body in every step.
bool could_be_pressed(const Collider& collider, const Body& body, double path,
                      const ContinuousCollision::Step& step) {
    double acceleration =
        body.inverse_mass * body.inverse_mass * body.force.squaredNorm();  // m^2/s^4, of the fastest point
    const double turning = body.inverse_inertia.maxCoeff();
    acceleration += turning * turning * body.torque.squaredNorm() * squared_turning_radius(collider.shape);
    const double room = (dangerous * size_of(collider.shape) - path) / (step.dt * step.dt);
    return room <= 0.0 || 2.0 * acceleration > room * room;  // (x + y)^2 <= 2 (x^2 + y^2)
}

Vector3 velocity_with_forces(const Body& body, double dt) {
    return body.inverse_mass * (body.linear_momentum + dt * body.force);
}

// The same for a body that nothing holds.
bool is_pressed_alone(const Collider& collider, const Body& body, const ContinuousCollision::Step& step) {
    return is_pressed(collider, body, velocity_with_forces(body, step.dt), step);
}

// Removes the part of a body's velocity that would close more along `normal` than the touch's gap. The other
// body counts with its velocity before the step, because something holds its weight too.
void stop_at(const Touch& touch, const Vector3& normal, const Body& other, double margin, double dt,
             Vector3& velocity_of_body) {
    double gap = infinity;
    for (const ContactPoint& point : touch.points) gap = std::min(gap, point.gap);
    if (gap > margin) return;
    const double excess = normal.dot(velocity_of_body - velocity(other)) - std::max(gap, 0.0) / dt;
    if (excess > 0.0) velocity_of_body -= excess * normal;
}

// Share of its size by which small steps may move a body differently than predicted.
constexpr double loose = 0.1;

// Whether the constraint force moves the body fast and differently than predicted: by more than its margin, or
// by more than `loose` of its size if the force comes from small steps.
bool is_thrown(const Collider& collider, const Body& body, const Vector6& force, NewForce kind,
               const ContinuousCollision::Step& step) {
    const double speed = step.dt * body.inverse_mass * force.head<3>().norm();
    const double rate = step.dt * body.inverse_inertia.maxCoeff() * force.tail<3>().norm();
    const double limit =
        kind == NewForce::of_small_steps ? loose * size_of(collider.shape) : margin_of(collider, step);
    if (path_of(collider, speed, rate, step.dt) <= limit) return false;
    const Motion motion = motion_of(body, step.dt, force);
    return path_of(collider, motion.velocity.norm(), motion.angular_velocity.norm(), step.dt) > limit;
}

bool bounces(const Collider& collider, const MaterialPairs* materials) {
    return collider.restitution > 0.0 || (materials && materials->bounces(collider.material));
}

// Distance at which two bodies have met, as a fraction of the size.
constexpr double met = 1e-4;

// Extra depth that a pair with rows may end the step with, as a fraction of the size.
constexpr double deep = 0.05;

bool before(const Touch& touch, const Pair& pair) {
    return touch.pair < pair;
}

double smallest_gap(std::span<const ContactPoint> points) {
    double gap = infinity;
    for (const ContactPoint& point : points) gap = std::min(gap, point.gap);
    return gap;
}

// Whether the free motion may take a touching pair beyond its manifold: into contact in a direction that the
// margin's normal does not foresee, or with corners outside the margin.
bool has_more(const Touch& touch, const Moving& a, const Moving& b, double dt, double margin) {
    const double gap = smallest_gap(touch.points);
    return approach(a, b, touch.normal, dt) > (gap > 0.0 ? gap : margin);
}

// Closing speed of the bodies at `point` when they meet, m/s.
double closing_speed(const Meeting& meeting, const Moving& a, const Moving& b, const Vector3& point) {
    const auto velocity = [&point](const Motion& motion, const Pose& pose) -> Vector3 {
        return motion.velocity + motion.angular_velocity.cross(point - pose.position);
    };
    const Vector3 relative = velocity(a.motion, meeting.pose_a) - velocity(b.motion, meeting.pose_b);
    return relative.dot(meeting.manifold.normal);
}

// For bouncing pairs, keeps the points that close by the incoming motion alone. A point that only the rebound
// brings down would be stopped in this step; left out, it bounces in its turn.
void keep_meeting_points(Meeting& meeting, const Moving& a, const Moving& b, double rest) {
    Manifold kept;
    kept.normal = meeting.manifold.normal;
    for (const ContactPoint& point : meeting.manifold.points()) {
        if (point.gap < rest * closing_speed(meeting, a, b, point.position)) kept.add(point);
    }
    if (kept.count > 0) meeting.manifold = kept;
}

// Converts gaps at the time of impact to gaps at the start of the step: adds the distance closed until then. A
// point that was opening meanwhile keeps its gap; that is too much room, but never pushes.
void wind_back(Meeting& meeting, const Moving& a, const Moving& b) {
    for (int i = 0; i < meeting.manifold.count; ++i) {
        ContactPoint& point = meeting.manifold.storage[static_cast<std::size_t>(i)];
        point.gap = std::max(0.0, point.gap + meeting.time * closing_speed(meeting, a, b, point.position));
    }
}

// The body with its momenta unchanged and its centre at `pose`.
Body moved_to(const Body& body, const Pose& pose) {
    Body moved = body;
    moved.position = pose.position;
    return moved;
}

}  // namespace

Moving ContinuousCollision::moving(int collider, const Step& step) const {
    const Collider& which = step.colliders[static_cast<std::size_t>(collider)];
    const auto body = static_cast<std::size_t>(which.body);
    return {which.shape, pose_of(step.bodies[body]), fast_pairs_.motion_of(collider)};
}

bool ContinuousCollision::any_fast(std::span<const Touch> touches, const Step& step) {
    fast_.assign(step.colliders.size(), false);
    dangerous_.assign(step.colliders.size(), false);
    bool any = false, any_pressed = false, any_moved = false;
    for (const int index : step.awake) {
        const auto i = static_cast<std::size_t>(index);
        const Collider& collider = step.colliders[i];
        const Body& body = step.bodies[static_cast<std::size_t>(collider.body)];
        if (body.is_static()) {
            any_moved = any_moved || body.is_moved();
            continue;
        }
        const double path = free_path(collider, body, step);
        dangerous_[i] = path > dangerous * size_of(collider.shape);
        fast_[i] = dangerous_[i] || (step.any_bounces && path > margin_of(collider, step));
        any = any || fast_[i];
        if (any_pressed || dangerous_[i]) continue;
        any_pressed = could_be_pressed(collider, body, path, step) && is_pressed_alone(collider, body, step);
    }
    if (any_moved) any = any_moved_fast(step) || any;
    if (!any_pressed) return any;
    find_pressed(touches, step);
    return std::find(fast_.begin(), fast_.end(), true) != fast_.end();
}

// A moved body does not rest on anything, so what it may bounce is swept however slowly it comes; and it may pass
// through what is smaller than itself.
bool ContinuousCollision::any_moved_fast(const Step& step) {
    bool any = false;
    for (const int index : step.awake) {
        const auto i = static_cast<std::size_t>(index);
        const Collider& collider = step.colliders[i];
        const Body& body = step.bodies[static_cast<std::size_t>(collider.body)];
        if (!body.is_moved()) continue;
        dangerous_[i] = may_pass_through(collider, body, step.colliders, step.bodies, step.dt);
        fast_[i] = dangerous_[i] || step.any_bounces;
        any = any || fast_[i];
    }
    return any;
}

// Bodies that lie on something are held: not fast, however hard they are pressed.
void ContinuousCollision::find_pressed(std::span<const Touch> touches, const Step& step) {
    freely_.resize(step.bodies.size());
    for (const int index : step.awake) {
        const auto body = static_cast<std::size_t>(step.colliders[static_cast<std::size_t>(index)].body);
        freely_[body] = velocity_with_forces(step.bodies[body], step.dt);
    }
    for (const Touch& touch : touches) {
        const auto a = static_cast<std::size_t>(touch.body_a), b = static_cast<std::size_t>(touch.body_b);
        const double margin = step.detection.margin * touch.size;
        if (!step.bodies[a].is_static()) stop_at(touch, touch.normal, step.bodies[b], margin, step.dt, freely_[a]);
        if (!step.bodies[b].is_static()) stop_at(touch, -touch.normal, step.bodies[a], margin, step.dt, freely_[b]);
    }
    for (const int index : step.awake) {
        const auto i = static_cast<std::size_t>(index);
        const Collider& collider = step.colliders[i];
        const auto number = static_cast<std::size_t>(collider.body);
        const Body& body = step.bodies[number];
        // Alone it has to be pressed too: whether another body of the world is must make no difference to it.
        if (body.is_static() || dangerous_[i] || !is_pressed_alone(collider, body, step)) continue;
        if (is_pressed(collider, body, freely_[number], step)) fast_[i] = dangerous_[i] = true;
    }
}

bool ContinuousCollision::any_thrown(std::span<const Vector6> forces, std::span<const NewForce> changed,
                                     const Step& step) {
    fast_.assign(step.colliders.size(), false);
    bool any = false;
    for (const int index : step.awake) {
        const auto i = static_cast<std::size_t>(index);
        const Collider& collider = step.colliders[i];
        const auto body = static_cast<std::size_t>(collider.body);
        if (changed[body] == NewForce::none) continue;
        fast_[i] = is_thrown(collider, step.bodies[body], forces[body], changed[body], step);
        any = any || fast_[i];
    }
    return any;
}

bool ContinuousCollision::is_swept(const Pair& pair, const Step& step) const {
    const auto a = static_cast<std::size_t>(pair.a), b = static_cast<std::size_t>(pair.b);
    const MaterialPairs* const materials = step.detection.materials;
    return dangerous_[a] || dangerous_[b] || bounces(step.colliders[a], materials) ||
           bounces(step.colliders[b], materials);
}

// Adds a touch for a pair that meets with the current motions.
ContinuousCollision::Outcome ContinuousCollision::add_meeting(const Pair& pair, const Step& step,
                                                              std::vector<Touch>& touches) {
    const Moving a = moving(pair.a, step);
    const Moving b = moving(pair.b, step);
    Touch touch;
    name_pair(pair, step.colliders, step.bodies, touch);
    combine_surfaces(step.colliders, step.detection.materials, touch);
    const double permitted = step.detection.permitted * touch.size;
    Course course = course_of(
        a, b, step.dt,
        {.tolerance = met * touch.size, .margin = step.detection.margin * touch.size, .permitted = permitted});
    std::optional<Meeting>& meeting = course.meeting;
    if (!meeting) return course.decided ? Outcome::passes : Outcome::undecided;
    if (touch.restitution > 0.0) keep_meeting_points(*meeting, a, b, step.dt - meeting->time);
    const bool doubtful = permitted > 0.0 && meeting->manifold.other_gap + permitted >= 0.0;
    if (meeting->time > 0.0) wind_back(*meeting, a, b);
    if (meeting->time > 0.0 || doubtful) keep_bodies(*meeting, step, touch);  // needed by take_out_held()
    keep_points(meeting->manifold, a, step, touch);
    touches.push_back(touch);
    return Outcome::meets;
}

void ContinuousCollision::keep_bodies(const Meeting& meeting, const Step& step, Touch& touch) {
    const Body& body_a = step.bodies[static_cast<std::size_t>(touch.body_a)];
    const Body& body_b = step.bodies[static_cast<std::size_t>(touch.body_b)];
    found_.bodies.push_back({moved_to(body_a, meeting.pose_a), moved_to(body_b, meeting.pose_b), meeting.time});
    touch.meeting = &found_.bodies.back();
}

void ContinuousCollision::keep_points(Manifold& manifold, const Moving& a, const Step& step, Touch& touch) {
    if (step.detection.reduce_to_four_points) reduce_to_four(manifold, a.start.rotation);
    touch.normal = manifold.normal;
    touch.points = found_.keep(manifold.points());
}

// Adds a second touch for a pair that has one but ends the step deep in each other because its rows turn it:
// with points and normal of the end of the step.
void ContinuousCollision::add_turned(const Touch& first, const Step& step, std::vector<Touch>& touches) {
    if (first.restitution > 0.0) return;
    const Moving a = moving(first.pair.a, step);
    const Moving b = moving(first.pair.b, step);
    Touch touch = first;
    Meeting end{.time = step.dt, .pose_a = pose_at(a, step.dt), .pose_b = pose_at(b, step.dt), .manifold = {}};
    collide(a.shape, end.pose_a, b.shape, end.pose_b, step.detection.margin * touch.size, end.manifold);
    const double before = std::min(0.0, smallest_gap(first.points));
    if (end.manifold.count == 0 || smallest_gap(end.manifold.points()) >= before - deep * touch.size) return;
    wind_back(end, a, b);
    keep_bodies(end, step, touch);
    keep_points(end.manifold, a, step, touch);
    touches.push_back(touch);
}

void ContinuousCollision::refine_fast(std::span<const Touch> touches, const Step& step, Detector& detector) {
    auto touch = touches.begin();
    const Outlook outlook{step.colliders, step.bodies, {}, step.dt, step.detection.margin};
    const std::span<const Pair> beside = detector.beside();
    for (const Pair& pair : fast_pairs_.find(outlook, step.awake, fast_, beside, detector.broad_phase())) {
        if (!is_swept(pair, step) && !std::binary_search(beside.begin(), beside.end(), pair)) continue;
        for (; touch != touches.end() && touch->pair < pair; ++touch) refined_.push_back(*touch);
        const bool touching = touch != touches.end() && touch->pair == pair;
        const double margin = touching ? step.detection.margin * touch->size : 0.0;
        if (touching && !has_more(*touch, moving(pair.a, step), moving(pair.b, step), step.dt, margin)) {
            refined_.push_back(*touch);
        } else {
            const Outcome outcome = add_meeting(pair, step, refined_);
            const bool stays = outcome == Outcome::undecided ||
                               (outcome == Outcome::passes && touching && smallest_gap(touch->points) <= 0.0);
            if (touching && stays) refined_.push_back(*touch);
        }
        if (touching) ++touch;
    }
    refined_.insert(refined_.end(), touch, touches.end());
    passing_.take_out_held(refined_, step);
}

std::span<const Touch> ContinuousCollision::refine(std::span<const Touch> touches, const Step& step,
                                                   Detector& detector) {
    found_.clear();
    seen_.clear();
    fast_pairs_.begin(step.colliders.size());
    known_ = touches;
    if (!any_fast(touches, step) && detector.beside().empty()) return known_;
    refined_.clear();
    refine_fast(touches, step, detector);
    known_ = refined_;
    return known_;
}

const Touch* ContinuousCollision::known(const Pair& pair) const {
    const auto touch = std::lower_bound(known_.begin(), known_.end(), pair, before);
    return touch != known_.end() && touch->pair == pair ? &*touch : nullptr;
}

std::span<const Touch> ContinuousCollision::look(std::span<const Vector6> forces, std::span<const NewForce> changed,
                                                 const Step& step, Detector& detector) {
    unforeseen_.clear();
    if (!any_thrown(forces, changed, step)) return unforeseen_;
    const Outlook outlook{step.colliders, step.bodies, forces, step.dt, step.detection.margin};
    for (const Pair& pair : fast_pairs_.find(outlook, step.awake, fast_, detector.broad_phase())) {
        if (std::binary_search(seen_.begin(), seen_.end(), pair)) continue;
        if (const Touch* touch = known(pair)) {
            add_turned(*touch, step, unforeseen_);
        } else {
            add_meeting(pair, step, unforeseen_);
        }
    }
    const auto middle = static_cast<std::ptrdiff_t>(seen_.size());
    for (const Touch& touch : unforeseen_) seen_.push_back(touch.pair);
    std::inplace_merge(seen_.begin(), seen_.begin() + middle, seen_.end());
    return unforeseen_;
}

}  // namespace pushfactor::engine::collision
