#include "engine/measures/step_length.h"

#include "engine/base/index.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine {

namespace {

// Constants of the rules in the header: largest dt times a frequency or angular velocity.
constexpr double swing_a_step = 0.5;
constexpr double turn_a_step = 0.034;  // rad

// The largest turn by a moment of 1 N m across r, 1/(kg m^2). Turning about r moves no point on it.
double softness_across(const Body& body, const Vector3& r) {
    if (r.isZero(0.0)) return 0.0;
    const Vector3 first = r.unitOrthogonal(), second = r.normalized().cross(first);
    const double a = first.cwiseAbs2().dot(body.inverse_inertia);
    const double b = second.cwiseAbs2().dot(body.inverse_inertia);
    const double both = first.cwiseProduct(second).dot(body.inverse_inertia);
    return 0.5 * (a + b) + elementary::hypot(0.5 * (a - b), both);
}

// omega^2 of one end under `force` on it [N]: about the end, and sideways with a bar of `length`, 0 for a joint.
double end_swing(const Body& body, const Vector3& point, const Vector3& force, double length) {
    const double softness = softness_across(body, point);
    const double outwards = std::abs(force.dot(body.orientation * point));
    if (length == 0.0) return outwards * softness;
    return outwards * softness + force.norm() * (body.inverse_mass + point.squaredNorm() * softness) / length;
}

Vector3 last_of(const Lambda& x, const Lambda& y, const Lambda& z) {
    return {x.last, y.last, z.last};
}

// omega^2 of a bar or a ball joint; 0 for a bar under compression.
double swing(const Distance& distance, const DistanceForce& force, std::span<const Body> bodies) {
    Vector3 pull = last_of(force[0], force[1], force[2]);
    if (!is_ball_joint(distance)) {
        if (!(force[0].last < 0.0)) return 0.0;
        const auto [from, to] = span_of(distance, bodies);
        pull = force[0].last * (to - from).normalized();
    }
    return end_swing(bodies[at(distance.body_a)], distance.point_a, pull, distance.length) +
           end_swing(bodies[at(distance.body_b)], distance.point_b, pull, distance.length);
}

// Angular velocity of an end that is off the centre [rad/s]. A ball joint sees nothing of a spin about the
// direction to it but that a stout body nods.
double end_turning(const Body& body, const Vector3& point, bool is_hinge) {
    if (point.isZero(0.0)) return 0.0;
    const Vector3 spin = angular_velocity(body);
    if (is_hinge) return spin.norm();
    const Vector3 direction = body.orientation * point.normalized();
    const double about = std::abs(direction.dot(spin));
    const double nods = std::abs(direction.dot(body.angular_momentum)) * softness_across(body, point);
    return elementary::hypot(direction.cross(spin).norm(), std::min(about, nods));
}

// Angular velocity of a bar's direction, or about an off-centre ball joint [rad/s].
double turning(const Distance& distance, std::span<const Body> bodies) {
    if (is_ball_joint(distance)) {
        return std::max(end_turning(bodies[at(distance.body_a)], distance.point_a, false),
                        end_turning(bodies[at(distance.body_b)], distance.point_b, false));
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
        largest = std::max(largest, swing(distances.distances()[i], distances.forces()[i], bodies));
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
        const Vector3 pull = last_of(force[0], force[1], force[2]);
        largest = std::max(largest, end_swing(bodies[at(joint.body_a)], joint.point_a, pull, 0.0) +
                                        end_swing(bodies[at(joint.body_b)], joint.point_b, pull, 0.0));
    }
    return std::sqrt(largest) / swing_a_step;
}

double turning_rate(const JointConstraints& joints, std::span<const Body> bodies) {
    double largest = 0.0;
    for (const Joint& joint : joints.joints()) {
        const bool is_hinge = joint.hinge.has_value();
        largest = std::max({largest, end_turning(bodies[at(joint.body_a)], joint.point_a, is_hinge),
                            end_turning(bodies[at(joint.body_b)], joint.point_b, is_hinge)});
    }
    return largest / turn_a_step;
}

}  // namespace pushfactor::engine
