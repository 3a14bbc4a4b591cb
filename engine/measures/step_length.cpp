#include "engine/measures/step_length.h"

#include "engine/base/index.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine {

namespace {

// Constants of the rules in the header: largest dt times a frequency or angular velocity.
constexpr double swing_a_step = 0.5;
constexpr double turn_a_step = 0.034;  // rad

// Contribution of one end of a bar or a ball joint to omega^2 / T, 1/(kg m).
double end_softness(const Body& body, const Vector3& point, double length) {
    const double r = point.norm();
    const double inverse_moment = body.inverse_inertia.maxCoeff();
    const double of_bar = length > 0.0 ? (body.inverse_mass + r * r * inverse_moment) / length : 0.0;
    return of_bar + r * inverse_moment;
}

// Tension of a bar, or force in a ball joint [N]; 0 for a bar under compression.
double tension(const Distance& distance, const DistanceForce& force) {
    if (!is_ball_joint(distance)) return std::max(0.0, -force[0].last);
    return Vector3(force[0].last, force[1].last, force[2].last).norm();
}

// Angular velocity of the bodies about an off-centre ball joint [rad/s].
double turning_about(const Vector3& point_a, const Body& a, const Vector3& point_b, const Body& b) {
    double largest = 0.0;
    if (!point_a.isZero(0.0)) largest = angular_velocity(a).norm();
    if (point_b.isZero(0.0)) return largest;
    return std::max(largest, angular_velocity(b).norm());
}

// Angular velocity of a bar's direction, or of the bodies about an off-centre ball joint [rad/s].
double turning(const Distance& distance, std::span<const Body> bodies) {
    if (is_ball_joint(distance)) {
        return turning_about(distance.point_a, bodies[at(distance.body_a)], distance.point_b,
                             bodies[at(distance.body_b)]);
    }
    const auto [from, to] = span_of(distance, bodies);
    const Vector3 p_ab = to - from;
    const double length = p_ab.norm();
    if (length == 0.0) return 0.0;
    const Vector3 v_ab =
        velocity_at(bodies[at(distance.body_b)], to) - velocity_at(bodies[at(distance.body_a)], from);
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
        const double softness = end_softness(bodies[at(distance.body_a)], distance.point_a, distance.length) +
                                end_softness(bodies[at(distance.body_b)], distance.point_b, distance.length);
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

double tension_rate(const JointConstraints& joints, std::span<const Body> bodies) {
    double largest = 0.0;  // omega^2
    for (std::size_t i = 0; i < joints.joints().size(); ++i) {
        const Joint& joint = joints.joints()[i];
        const JointForce& force = joints.forces()[i];
        const double softness = end_softness(bodies[at(joint.body_a)], joint.point_a, 0.0) +
                                end_softness(bodies[at(joint.body_b)], joint.point_b, 0.0);
        largest = std::max(largest, Vector3(force[0].last, force[1].last, force[2].last).norm() * softness);
    }
    return std::sqrt(largest) / swing_a_step;
}

double turning_rate(const JointConstraints& joints, std::span<const Body> bodies) {
    double largest = 0.0;
    for (const Joint& joint : joints.joints()) {
        largest = std::max(largest, turning_about(joint.point_a, bodies[at(joint.body_a)], joint.point_b,
                                                  bodies[at(joint.body_b)]));
    }
    return largest / turn_a_step;
}

}  // namespace pushfactor::engine
