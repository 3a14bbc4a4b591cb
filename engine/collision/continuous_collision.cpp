#include "engine/collision/continuous_collision.h"

#include "engine/base/constants.h"
#include "engine/collision/meeting.h"
#include "engine/collision/pairs/collide.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine::collision {

namespace {

// By how much more than rounding a gap along one direction is below the largest of all, as a share of the size.
constexpr double surely = 1e-6;

// Upper bound on the path of a point of the shape [m].
double path_of(const Shape& shape, double speed, double rate, double dt) {
    return dt * (speed + rate * std::sqrt(squared_turning_radius(shape)));
}

// Whether the body moves otherwise than its rows know: because the constraint force moves it by more than its
// margin, as where it stops it before one that follows it, or because it turns by as much, in which no row follows.
bool is_thrown(const Collider& collider, const Body& body, const Vector6& force, const StepScene& scene) {
    const double dt = scene.motions->dt;
    const double limit = size_of(collider.shape) * scene.detection.margin;
    const double speed = dt * body.inverse_mass * force.head<3>().norm();
    const double rate = dt * body.inverse_inertia.maxCoeff() * force.tail<3>().norm();
    const Motion& motion = scene.motions->path_of(collider.body);
    const double turning = turns_in_itself(collider.shape) ? 0.0 : motion.angular_velocity.norm();
    return path_of(collider.shape, speed, rate, dt) > limit || path_of(collider.shape, 0.0, turning, dt) > limit;
}

// How deep the points of a touch that has no rows take the bodies into each other by the end of the step [m]: as
// its rows would see it, whose lever arms are those of the time at which they meet.
double depth_at_end(const Touch& touch, const StepScene& scene) {
    const Vector3 centre_a = scene.centre(touch.body_a, touch.time),
                  centre_b = scene.centre(touch.body_b, touch.time);
    const Motion& after_a = scene.motions->after[static_cast<std::size_t>(touch.body_a)];
    const Motion& after_b = scene.motions->after[static_cast<std::size_t>(touch.body_b)];
    double depth = -infinity;
    for (const ContactPoint& point : touch.points) {
        const double speed = closing_speed(after_a, centre_a, after_b, centre_b, point.position, touch.normal);
        depth = std::max(depth, speed * scene.motions->dt - point.gap);
    }
    return depth;
}

// Whether a pair that has a touch ends the step deep in each other because its rows turn it; then with the points
// and the normal of the end of the step in `manifold`.
bool ends_deep(const Touch& first, const StepScene& scene, Manifold& manifold, Touch& touch) {
    if (first.restitution > 0.0) return false;
    const double deep = std::min(0.0, std::ranges::min(first.points, {}, &ContactPoint::gap).gap) -
                        constants::collision::deep * first.size;
    if (gap_at_end(scene, first) > deep + surely * first.size) return false;
    touch = first;
    touch.time = scene.motions->dt;
    touch.ends_deep = true;
    const bool meets = contact_at_end(scene, touch, manifold);
    touch.normal = manifold.normal;
    return meets && manifold.separation < deep;
}

}  // namespace

void ContinuousCollision::begin(std::span<const Touch> touches) {
    known_ = touches;
    found_.clear();
}

// Puts the boxes of the thrown ones along their new motion.
bool ContinuousCollision::any_thrown(const StepScene& scene, std::span<const Vector6> forces,
                                     std::span<const char> changed, std::span<const int> awake,
                                     BroadPhase& broad_phase, Threads* threads) {
    thrown_.assign(scene.colliders.size(), 0);
    const auto look_at = [&](int index) {
        const auto i = static_cast<std::size_t>(index);
        const Collider& collider = scene.colliders[i];
        const auto body = static_cast<std::size_t>(collider.body);
        if (!changed[body] || !is_thrown(collider, scene.bodies[body], forces[body], scene)) return;
        thrown_[i] = 1;
        broad_phase.put(index, swept_box(collider.shape, scene.poses[body], scene.motions->paths[body],
                                         scene.motions->dt, scene.detection.margin * size_of(collider.shape)));
    };
    share_each(threads, awake, bodies_of_a_part, look_at);
    return std::ranges::find(thrown_, 1) != thrown_.end();
}

const Touch* ContinuousCollision::known(const Pair& pair) const {
    for (const std::span<const Touch> touches : {known_, std::span<const Touch>(found_)}) {
        const auto touch = std::ranges::lower_bound(touches, pair, {}, &Touch::pair);
        if (touch != touches.end() && touch->pair == pair) return &*touch;
    }
    return nullptr;
}

// Whether the pair needs other rows than it has; then with their points in `manifold`.
bool ContinuousCollision::is_missing(const Pair& pair, const StepScene& scene, Manifold& manifold,
                                     Touch& touch) const {
    if (const Touch* const first = known(pair)) return ends_deep(*first, scene, manifold, touch);
    return find_touch(pair, scene, manifold, touch) &&
           depth_at_end(touch, scene) > constants::collision::deep_without_rows * touch.size;
}

std::span<const Touch> ContinuousCollision::look(const StepScene& scene, std::span<const Vector6> forces,
                                                 std::span<const char> changed, std::span<const int> awake,
                                                 BroadPhase& broad_phase, Threads* threads) {
    unforeseen_.clear();
    if (!any_thrown(scene, forces, changed, awake, broad_phase, threads)) return unforeseen_;
    unforeseen_ = search_.among(broad_phase.find_pairs_of(thrown_, threads), threads,
                                [&](const Pair& pair, Manifold& manifold, Touch& touch) {
                                    return is_missing(pair, scene, manifold, touch);
                                });
    for (Touch& touch : unforeseen_) touch.points = scene.kept->keep(touch.points);
    if (scene.detection.permitted > 0.0) seams_.put_right(scene, known_, unforeseen_);
    for (Touch& touch : unforeseen_) {
        found_.insert(std::ranges::upper_bound(found_, touch.pair, {}, &Touch::pair), touch);
    }
    return unforeseen_;
}

}  // namespace pushfactor::engine::collision
