#include "engine/collision/meeting.h"

#include "engine/base/constants.h"
#include "engine/collision/pairs/collide.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pushfactor::engine::collision {

namespace {

// Directions of turning that are tried at most.
constexpr int most_directions = 32;

// A pair at a time of the step, and what is left of it.
struct Met {
    const StepScene& scene;
    const Touch& touch;
    double margin;  // m
    double rest;    // s
    Moving a, b;

    // By motions of all bodies, or on their paths [m/s].
    double closing(std::span<const Motion> motions, const Vector3& point, const Vector3& normal) const {
        return closing_speed(motions[static_cast<std::size_t>(touch.body_a)], a.start.position,
                             motions[static_cast<std::size_t>(touch.body_b)], b.start.position, point, normal);
    }
    double closing(const Vector3& point, const Vector3& normal) const {
        return closing_speed(a.motion, a.start.position, b.motion, b.start.position, point, normal);
    }
};

// The time in which contacts are found [s]. Without a margin there are those of now alone, as in the paper.
double time_ahead(const StepScene& scene) {
    return scene.detection.margin > 0.0 ? scene.motions->dt : 0.0;
}

Met met_at(const StepScene& scene, const Touch& touch, double time, double margin) {
    Met met{scene,
            touch,
            margin,
            std::max(0.0, time_ahead(scene) - time),
            scene.moving(touch.pair.a),
            scene.moving(touch.pair.b)};
    met.a.start = pose_at(met.a, time);
    met.b.start = pose_at(met.b, time);
    return met;
}

// The points below the margin, and those that the rest of the step closes.
void find_points(const Met& met, Manifold& manifold) {
    const auto is_ball = [](const Shape& shape) { return std::holds_alternative<Sphere>(shape); };
    if (manifold.count > 0 && (is_ball(met.a.shape) || is_ball(met.b.shape))) return;  // there is no other point
    const double reach = approach(met.a, met.b, manifold.normal, met.rest);
    if (reach <= met.margin) return;
    collide(met.a.shape, met.a.start, met.b.shape, met.b.start, met.margin + reach, manifold);
    const auto stays_open = [&](const ContactPoint& point) {
        const double closed = met.rest * met.closing(point.position, manifold.normal);
        return !(point.gap < met.margin + std::max(0.0, closed));
    };
    const std::span<ContactPoint> points = manifold.points();
    manifold.count = static_cast<int>(std::remove_if(points.begin(), points.end(), stays_open) - points.begin());
}

// Of many points those that may carry the bodies in this step.
void choose_points(const Met& met, Manifold& manifold) {
    if (manifold.count <= 4) return;
    const bool deep = met.touch.ends_deep;
    std::array<double, Manifold::most_points> ends;
    double path = 0.0;
    for (std::size_t i = 0; i < manifold.points().size(); ++i) {
        const ContactPoint& point = manifold.points()[i];
        ends[i] = point.gap - met.rest * met.closing(point.position, manifold.normal);
        // The momenta before the step can turn the bodies on each other.
        const double before = met.closing(met.scene.motions->before, point.position, manifold.normal);
        if (!deep) path = std::max(path, time_ahead(met.scene) * std::abs(before));
    }
    const double unseen = constants::collision::unseen * met.touch.size;
    keep_carrying({.ends = {ends.data(), manifold.points().size()},
                   .path = path,
                   .room = std::max(met.margin, unseen),
                   .allowed = unseen},
                  met.a.start.rotation, deep || met.scene.detection.reduce_to_four_points ? 4 : 8, most_directions,
                  manifold);
}

// Writes the contact at `time` [s] of the step. Turns gaps at that time into those that rows need: if the bodies
// move freely they have, by the end of the step, closed what the path has closed. A row takes the velocity at the
// time of the meeting for that of the whole step, so the way until then is the one that it sees. A point that was
// opening meanwhile keeps its gap; that is too much room, but never pushes.
bool contact_at(const StepScene& scene, const Touch& touch, double time, double margin, Manifold& manifold) {
    const Met met = met_at(scene, touch, time, margin);
    collide(met.a.shape, met.a.start, met.b.shape, met.b.start, margin, manifold);
    find_points(met, manifold);
    choose_points(met, manifold);
    for (ContactPoint& point : manifold.points()) {
        point.gap += time * met.closing(scene.motions->after, point.position, manifold.normal);
        if (!touch.ends_deep) point.gap = std::max(0.0, point.gap);
    }
    return manifold.count > 0;
}

}  // namespace

double closing_speed(const Motion& a, const Vector3& centre_a, const Motion& b, const Vector3& centre_b,
                     const Vector3& point, const Vector3& normal) {
    const Vector3 of_a = a.velocity + a.angular_velocity.cross(point - centre_a);
    const Vector3 of_b = b.velocity + b.angular_velocity.cross(point - centre_b);
    return normal.dot(of_a - of_b);
}

bool meet(const StepScene& scene, Touch& touch, Manifold& manifold) {
    const double dt = time_ahead(scene), margin = scene.detection.margin * touch.size;
    const Met now{scene, touch, margin, dt, scene.moving(touch.pair.a), scene.moving(touch.pair.b)};
    touch.time = 0.0;
    collide(now.a.shape, now.a.start, now.b.shape, now.b.start, margin, manifold);
    const double gap = manifold.smallest_gap(), tolerance = constants::collision::meeting_gap * touch.size;
    if (gap > tolerance && (scene.motions->has_strayed(touch.body_a) || scene.motions->has_strayed(touch.body_b))) {
        touch.time = dt;
        // Whatever comes as near fast enough has been an impact.
        return contact_at(scene, touch, dt, 0.5 * tolerance, manifold);
    }
    if (gap > tolerance) {
        const double reach = approach(now.a, now.b, manifold.normal, dt);
        Course course;
        if (reach > gap) {
            course = course_of(now.a, now.b, dt, tolerance);
            if (!course.decided) return manifold.count > 0;
        } else if (manifold.count > 0) {
            choose_points(now, manifold);
            return true;
        }
        if (course.time == never && reach <= gap - margin) return false;
        touch.time = std::min(course.time, dt);  // it meets, or may end near
    }
    if (touch.time > 0.0) return contact_at(scene, touch, touch.time, margin, manifold);
    find_points(now, manifold);
    choose_points(now, manifold);
    return manifold.count > 0;
}

bool contact_at_end(const StepScene& scene, const Touch& touch, Manifold& manifold) {
    return contact_at(scene, touch, scene.motions->dt, scene.detection.margin * touch.size, manifold);
}

double gap_at_end(const StepScene& scene, const Touch& touch) {
    Moving a = scene.moving(touch.pair.a), b = scene.moving(touch.pair.b);
    a.start = pose_at(a, scene.motions->dt);
    b.start = pose_at(b, scene.motions->dt);
    return gap_along(a, b, touch.normal);
}

}  // namespace pushfactor::engine::collision
