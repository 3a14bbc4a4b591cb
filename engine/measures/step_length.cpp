#include "engine/measures/step_length.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine {

namespace {

// The constants of the header's rules, as what dt times a frequency or an angular velocity may be.
constexpr double swing_a_step = 0.5;
constexpr double turn_a_step = 0.1;       // rad
constexpr double fall_a_step = 0.02;      // of the size
constexpr double slender_moments = 10.0;  // largest over smallest

const Body& at(std::span<const Body> bodies, int index) {
    return bodies[static_cast<std::size_t>(index)];
}

// What one end of a bar or a ball joint adds to omega^2 / T, 1/(kg m).
double end_softness(const Body& body, const Vector3& point, double length) {
    const double r = point.norm();
    const double inverse_moment = body.inverse_inertia.maxCoeff();
    const double of_bar = length > 0.0 ? (body.inverse_mass + r * r * inverse_moment) / length : 0.0;
    return of_bar + r * inverse_moment;
}

// What pulls the ends of a bar together, or acts in a ball joint [N]; 0 where a bar is pressed.
double tension(const Distance& distance, const DistanceForce& force) {
    if (!is_ball_joint(distance)) return std::max(0.0, -force[0].last);
    return Vector3(force[0].last, force[1].last, force[2].last).norm();
}

// How fast the direction of a bar turns, or the bodies about a ball joint beside their centres [rad/s].
double turning(const Distance& distance, std::span<const Body> bodies) {
    if (is_ball_joint(distance)) {
        double largest = 0.0;
        if (!distance.point_a.isZero(0.0)) largest = angular_velocity(at(bodies, distance.body_a)).norm();
        if (distance.point_b.isZero(0.0)) return largest;
        return std::max(largest, angular_velocity(at(bodies, distance.body_b)).norm());
    }
    const auto [from, to] = span_of(distance, bodies);
    const Vector3 p_ab = to - from;
    const double length = p_ab.norm();
    if (length == 0.0) return 0.0;
    const Vector3 v_ab =
        velocity_at(at(bodies, distance.body_b), to) - velocity_at(at(bodies, distance.body_a), from);
    return p_ab.cross(v_ab).norm() / (length * length);
}

bool holds(const Distance& distance, const DistanceForce& force) {
    return distance.acts == Distance::Acts::both || force[0].last != 0.0;
}

}  // namespace

double tension_rate(const DistanceConstraints& distances, std::span<const Body> bodies) {
    double largest = 0.0;  // omega^2
    for (std::size_t i = 0; i < distances.distances().size(); ++i) {
        const Distance& distance = distances.distances()[i];
        const double softness = end_softness(at(bodies, distance.body_a), distance.point_a, distance.length) +
                                end_softness(at(bodies, distance.body_b), distance.point_b, distance.length);
        largest = std::max(largest, tension(distance, distances.forces()[i]) * softness);
    }
    return std::sqrt(largest) / swing_a_step;
}

double turning_rate(const DistanceConstraints& distances, std::span<const Body> bodies) {
    double largest = 0.0;
    for (std::size_t i = 0; i < distances.distances().size(); ++i) {
        const Distance& distance = distances.distances()[i];
        if (holds(distance, distances.forces()[i])) {
            largest = std::max(largest, turning(distance, bodies));
        }
    }
    return largest / turn_a_step;
}

bool is_slender(const Body& body) {
    return body.inverse_inertia.maxCoeff() > slender_moments * body.inverse_inertia.minCoeff();
}

double spin_rate(std::span<const Body> bodies) {
    double largest = 0.0;
    for (const Body& body : bodies) {
        if (is_slender(body)) largest = std::max(largest, angular_velocity(body).norm());
    }
    return largest / turn_a_step;
}

double size_rate(std::span<const collision::Collider> colliders, std::span<const Body> bodies,
                 const Vector3& gravity) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const collision::Collider& collider : colliders) {
        if (!at(bodies, collider.body).is_static()) smallest = std::min(smallest, size_of(collider.shape));
    }
    return std::sqrt(gravity.norm() / (fall_a_step * smallest));
}

}  // namespace pushfactor::engine
