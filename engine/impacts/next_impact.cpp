#include "engine/impacts/next_impact.h"

#include "engine/base/constants.h"
#include "engine/collision/meeting.h"
#include "engine/collision/pairs/collide.h"
#include "engine/collision/time_of_impact.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine {

namespace {

// Gap at which a meeting counts as found, and steps of Newton's method for it.
constexpr double found_gap = 1e-12;
constexpr int most_refinements = 8;
// Limit on how often a pair is looked at in a step.
constexpr int most_looks = 200;

collision::Moving moving(const Flier& flier, const Body& now, double time, double until) {
    return {flier.shape, collision::pose_of(now), flier.flight.motion(time, until)};
}

Body placed(const Flier& flier, double time) {
    return flier.turning == 0.0 ? flier.flight.shifted(time) : flier.flight.at(time);
}

// Both bodies at one time, and what they have in contact.
struct Look {
    Look(const Flier& of_a, const Flier& of_b, double time, double margin, collision::Manifold& manifold)
        : a(placed(of_a, time)), b(placed(of_b, time)) {
        collision::collide(of_a.shape, collision::pose_of(a), of_b.shape, collision::pose_of(b), margin, manifold);
        gap = manifold.smallest_gap();
    }

    Body a, b;
    double gap = 0.0;  // m
};

double fastest_approach(const Look& look, const collision::Manifold& manifold) {
    const Motion a = motion_of(look.a), b = motion_of(look.b);
    double fastest = -infinity;
    for (const collision::ContactPoint& point : manifold.points()) {
        fastest = std::max(fastest, collision::closing_speed(a, look.a.position, b, look.b.position, point.position,
                                                             manifold.normal));
    }
    return fastest;
}

// For how long a pair that touches without an impact needs not be looked at, if it separates at `speed` [m/s].
double time_apart(const Flier& a, const Flier& b, const Look& look, double speed, const ImpactLimits& limits) {
    const double usual = limits.dt / constants::impacts::looks_per_step;
    if (!(speed > 0.0)) return usual;
    const double turning =
        a.turning * angular_velocity(look.a).norm() + b.turning * angular_velocity(look.b).norm();
    const double change = (a.flight.acceleration() - b.flight.acceleration()).norm();
    // Where nothing turns convex shapes go on to separate; else other points may follow.
    if (turning == 0.0) return std::max(usual, speed / std::max(change, speed / limits.dt));
    const double fastest = turning + (velocity(look.a) - velocity(look.b)).norm();
    return std::min(usual, std::max(4.0 * constants::collision::meeting_gap * limits.size / speed,
                                    constants::impacts::unseen_way * limits.size / fastest));
}

// Whether the balls around both shapes cannot meet from `from` on.
bool are_apart(const Flier& a, const Flier& b, const ImpactLimits& limits, double from) {
    const double rest = limits.dt - from;
    const double reach = a.radius + b.radius + 2.0 * constants::collision::meeting_gap * limits.size;
    const double way = rest * (a.flight.velocity_at(from) - b.flight.velocity_at(from)).norm() +
                       rest * rest * (a.flight.acceleration() - b.flight.acceleration()).norm();
    return (a.flight.position_at(from) - b.flight.position_at(from)).norm() > reach + way;
}

}  // namespace

double ImpactLimits::least_speed(const Vector3& normal, const Vector3& fall_a, const Vector3& fall_b) const {
    const double weight = std::max(std::abs(normal.dot(fall_a)), std::abs(normal.dot(fall_b)));
    return std::max({least, weight * dt, std::sqrt(2.0 * weight * touching)});
}

NextImpact next_impact(const Flier& a, const Flier& b, const ImpactLimits& limits, double from,
                       collision::Manifold& manifold) {
    const double dt = limits.dt, tolerance = constants::collision::meeting_gap * limits.size;
    if (are_apart(a, b, limits, from)) return {};
    double time = from;
    for (int looks = 0; looks < most_looks && time < dt; ++looks) {
        Look look(a, b, time, 2.0 * tolerance, manifold);
        if (look.gap > tolerance || manifold.count == 0) {
            if (look.gap <= tolerance) {
                time += dt / constants::impacts::looks_per_step;  // close along all axes, but without points
                continue;
            }
            const double until = std::min(a.flight.steady_until(time), b.flight.steady_until(time));
            const collision::Course course = collision::course_of(
                moving(a, look.a, time, until), moving(b, look.b, time, until), until - time, tolerance);
            if (course.time == never) {
                time = course.decided ? until : time + dt / constants::impacts::looks_per_step;
                continue;
            }
            time += course.time;
        }
        // From the chord of the flight to the flight itself, and through the tolerance.
        double meeting = time;
        for (int i = 0; i < most_refinements; ++i) {
            look = Look(a, b, meeting, 2.0 * tolerance, manifold);
            if (manifold.count == 0) look = Look(a, b, meeting, 2.0 * look.gap, manifold);
            const double speed = fastest_approach(look, manifold);
            if (manifold.count == 0 || !(speed > 0.0)) break;
            if (std::abs(look.gap) <= found_gap * limits.size) break;
            const double next = meeting + look.gap / speed;
            if (next < from || next >= dt) break;  // it overlaps already, or closes the gap in a later step
            meeting = next;
        }
        look = Look(a, b, meeting, 2.0 * tolerance, manifold);
        const double speed = fastest_approach(look, manifold);
        const double least = std::max(limits.least_speed(manifold.normal, a.flight.fall(), b.flight.fall()),
                                      rounding_of_speeds * (velocity(look.a).norm() + velocity(look.b).norm()));
        if (manifold.count > 0 && look.gap <= 2.0 * tolerance && speed > least) return {meeting, speed};
        time = std::max(time, meeting) + time_apart(a, b, look, manifold.count > 0 ? -speed : 0.0, limits);
    }
    return {};
}

}  // namespace pushfactor::engine
