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

// A pair at the time of its meeting, and what is left of the step.
struct Met {
    Moving a, b;
    double rest = 0.0;  // s

    double closing(const Vector3& point, const Vector3& normal) const {
        return closing_speed(a.motion, a.start.position, b.motion, b.start.position, point, normal);
    }
};

// The points below the margin, and those that the rest of the step closes.
void find_points(const Met& met, const Encounter& encounter, Manifold& manifold) {
    const double reach = approach(met.a, met.b, manifold.normal, met.rest);
    if (reach <= encounter.margin) return;
    collide(met.a.shape, met.a.start, met.b.shape, met.b.start, encounter.margin + reach, manifold);
    const auto stays_open = [&](const ContactPoint& point) {
        const double closed = met.rest * met.closing(point.position, manifold.normal);
        return !(point.gap < encounter.margin + std::max(0.0, closed));
    };
    manifold.count -= static_cast<int>(std::ranges::remove_if(manifold.points(), stays_open).size());
}

// Of many points those that may carry the bodies in this step.
void choose_points(const Met& met, const Encounter& encounter, Manifold& manifold) {
    if (manifold.count <= 4) return;
    std::array<double, Manifold::most_points> ends;
    double path = 0.0;
    for (std::size_t i = 0; i < manifold.points().size(); ++i) {
        const ContactPoint& point = manifold.points()[i];
        ends[i] = point.gap - met.rest * met.closing(point.position, manifold.normal);
        const double before = closing_speed(encounter.before_a, met.a.start.position, encounter.before_b,
                                            met.b.start.position, point.position, manifold.normal);
        path = std::max(path, encounter.dt * std::abs(before));
    }
    keep_carrying({.ends = {ends.data(), manifold.points().size()},
                   .path = path,
                   .room = std::max(encounter.margin, constants::collision::unseen * encounter.size),
                   .allowed = constants::collision::unseen * encounter.size},
                  met.a.start.rotation, encounter.least_directions, most_directions, manifold);
}

// Turns gaps at the time of the meeting into those that its rows need: if the bodies move freely they have, by the
// end of the step, closed what the path has closed. A row takes the velocity at the time of the meeting for that of
// the whole step, so the way until then is the one that it sees. A point that was opening meanwhile keeps its gap;
// that is too much room, but never pushes.
void wind_back(const Met& met, const Encounter& encounter, double time, Manifold& manifold) {
    for (ContactPoint& point : manifold.points()) {
        const double speed = closing_speed(encounter.after_a, met.a.start.position, encounter.after_b,
                                           met.b.start.position, point.position, manifold.normal);
        point.gap += time * speed;
        if (!encounter.pushes) point.gap = std::max(0.0, point.gap);
    }
}

}  // namespace

double closing_speed(const Motion& a, const Vector3& centre_a, const Motion& b, const Vector3& centre_b,
                     const Vector3& point, const Vector3& normal) {
    const Vector3 of_a = a.velocity + a.angular_velocity.cross(point - centre_a);
    const Vector3 of_b = b.velocity + b.angular_velocity.cross(point - centre_b);
    return normal.dot(of_a - of_b);
}

bool meet(const Moving& a, const Moving& b, const Encounter& encounter, Manifold& manifold, double& time) {
    time = 0.0;
    collide(a.shape, a.start, b.shape, b.start, encounter.margin, manifold);
    const double gap = manifold.smallest_gap(), tolerance = constants::collision::meeting_gap * encounter.size;
    if (gap > tolerance && encounter.strayed) {
        Encounter ends = encounter;
        ends.margin = 0.5 * tolerance;  // whatever comes as near fast enough has been an impact
        time = encounter.dt;
        return contact_at(a, b, ends, time, manifold);
    }
    if (gap > tolerance) {
        const double reach = approach(a, b, manifold.normal, encounter.dt);
        Course course;
        if (reach > gap) {
            course = course_of(a, b, encounter.dt, tolerance);
            if (!course.decided) return manifold.count > 0;
        } else if (manifold.count > 0) {
            choose_points({a, b, encounter.dt}, encounter, manifold);
            return true;
        }
        if (course.time == never && reach <= gap - encounter.margin) return false;
        time = std::min(course.time, encounter.dt);  // it meets, or may end near
    }
    if (time > 0.0) return contact_at(a, b, encounter, time, manifold);
    const Met now{a, b, encounter.dt};
    find_points(now, encounter, manifold);
    choose_points(now, encounter, manifold);
    return manifold.count > 0;
}

bool contact_at(const Moving& a, const Moving& b, const Encounter& encounter, double time, Manifold& manifold) {
    const Met met{
        {a.shape, pose_at(a, time), a.motion}, {b.shape, pose_at(b, time), b.motion}, encounter.dt - time};
    collide(a.shape, met.a.start, b.shape, met.b.start, encounter.margin, manifold);
    find_points(met, encounter, manifold);
    choose_points(met, encounter, manifold);
    wind_back(met, encounter, time, manifold);
    return manifold.count > 0;
}

}  // namespace pushfactor::engine::collision
