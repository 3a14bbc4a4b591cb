#include "engine/constraints/joint_constraints.h"

#include "engine/constraints/point_jacobian.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

namespace pushfactor::engine {

namespace {

// L.
double lever_of(const BodyPair& pair) {
    double squared = infinity;
    for (const Body* const body : {&pair.body_a, &pair.body_b}) {
        const double softest = body->inverse_inertia.maxCoeff();
        if (softest > 0.0 && body->inverse_mass > 0.0) squared = std::min(squared, body->inverse_mass / softest);
    }
    return std::isfinite(squared) ? std::sqrt(squared) : 1.0;
}

// How b is turned from where it is at angle 0, in the frame of a.
Quaternion turn_of(const Joint& joint, const BodyPair& bodies) {
    return bodies.body_a.orientation.conjugate() * bodies.body_b.orientation * joint.hinge->zero.conjugate();
}

// The part of a turn about `axis`, in (-pi, pi] [rad].
double twist(const Quaternion& turn, const Vector3& axis) {
    const double along = turn.vec().dot(axis);
    return turn.w() < 0.0 ? 2.0 * elementary::atan2(-along, -turn.w()) : 2.0 * elementary::atan2(along, turn.w());
}

// theta: the shortest rotation from `axis` to `other`, both of unit length.
Vector3 rotation_between(const Vector3& axis, const Vector3& other) {
    const Vector3 across = axis.cross(other);
    const double sine = across.norm(), cosine = axis.dot(other);
    if (sine > 0.0) return elementary::atan2(sine, cosine) / sine * across;
    return cosine < 0.0 ? Vector3(std::numbers::pi * axis.unitOrthogonal()) : Vector3(Vector3::Zero());
}

// What is left to the lower limit (side 1) or to the upper one (side -1) [rad].
double gap_to(const AngleLimits& limits, double side, double angle) {
    return side > 0.0 ? angle - limits.low : limits.high - angle;
}

// A row j_c = [0, -axis, 0, axis].
ConstraintRow& append_turn(const BodyPair& pair, const Vector3& axis, RowList& rows) {
    ConstraintRow& row = rows.emplace_back();
    row.body_a = pair.a;
    row.body_b = pair.b;
    if (!pair.body_a.is_static()) row.jacobian.a.tail<3>() = -axis;
    if (!pair.body_b.is_static()) row.jacobian.b.tail<3>() = axis;
    return row;
}

bool is_bounded(const ConstraintRow& row) {
    return row.bounds.c_min > -infinity || row.bounds.c_max < infinity;
}

// A motor without a largest torque turns as it should, and stops at its limit by itself: a row of the limit beside
// its own would share one force with it in any way.
bool has_limit_rows(const Hinge& hinge) {
    return hinge.limits && !(hinge.motor && !hinge.motor->servo && std::isinf(hinge.motor->max_torque));
}

bool needs_angle(const Joint& joint) {
    return joint.hinge && (joint.hinge->limits || (joint.hinge->motor && joint.hinge->motor->servo));
}

}  // namespace

double angle_of(const Joint& joint, std::span<const Body> bodies) {
    return twist(turn_of(joint, pair_of(joint, bodies)), joint.hinge->axis);
}

std::size_t row_count(const Joint& joint) {
    if (!joint.hinge) return 3;
    const Hinge& hinge = *joint.hinge;
    return 5u + (hinge.motor ? 1 : 0) +
           (!has_limit_rows(hinge)                   ? 0
            : hinge.limits->low < hinge.limits->high ? 2
                                                     : 1);
}

JointConstraints::JointConstraints(std::vector<Joint> joints, const Correction& correction, bool cached)
    : HeldPairs(std::move(joints), correction, cached),
      angles_(items_.size(), std::numeric_limits<double>::quiet_NaN()) {}

void JointConstraints::append_rows(const StepStart& step, RowList& rows) {
    for (const std::size_t i : acting_) {
        if (needs_angle(items_[i])) angles_[i] = angle_near(i, pair_of(items_[i], step.bodies));
    }
    HeldPairs::append_rows(step, rows);
}

void JointConstraints::append_rows_of(std::size_t index, const BodyPair& bodies, double dt, RowList& rows) const {
    const Joint& joint = items_[index];
    const std::size_t first = rows.size();
    const auto [p_a, p_b] = span_of(joint, bodies);
    append_point_rows(bodies, p_a, p_b, correction_, dt, rows);
    for (std::size_t j = first; j < rows.size(); ++j) {
        rows[j].label = {.kind = RowKind::joint, .point = static_cast<int>(index), .gap = (p_b - p_a).norm()};
    }
    if (joint.hinge) append_hinge(index, bodies, dt, rows);
    assert(rows.size() - first == row_count(joint));
    for (std::size_t j = first; joint.closes_loop && j < rows.size(); ++j) {
        if (!is_bounded(rows[j])) soften(bodies.body_a, bodies.body_b, rows[j]);
    }
    for (std::size_t j = first; cached_ && j < rows.size(); ++j) rows[j].guess = forces_[index][j - first];
}

void JointConstraints::append_hinge(std::size_t index, const BodyPair& pair, double dt, RowList& rows) const {
    const Joint& joint = items_[index];
    const Hinge& hinge = *joint.hinge;
    const double lever = lever_of(pair);
    const Quaternion turn = turn_of(joint, pair), &frame = pair.body_a.orientation;
    // Of rows about some axes, which turn with a.
    const auto rates_about = [&](std::span<const Vector3> axes) {
        const FreeTurn a(pair.body_a), b(pair.body_b);
        const Vector3 w = b.w - a.w, acceleration = b.acceleration - a.acceleration;
        HeldRates rates;
        for (std::size_t k = 0; k < axes.size(); ++k)
            rates[k] = {w.dot(axes[k]), acceleration.dot(axes[k]) + w.dot(a.w.cross(axes[k]))};
        return rates;
    };
    // A row about `axis` that has the error `error` [m].
    const auto append = [&](const Vector3& axis, RowKind kind, double error) -> ConstraintRow& {
        ConstraintRow& row = append_turn(pair, axis, rows);
        row.error = error;
        row.label = {.kind = kind, .point = static_cast<int>(index), .gap = error};
        return row;
    };

    const Vector3 theta = rotation_between(hinge.axis, turn * hinge.axis);
    const Vector3 across = hinge.axis.unitOrthogonal();
    std::array<Vector3, 2> axes{across, hinge.axis.cross(across)};
    for (Vector3& t : axes) {
        const double error = lever * theta.dot(t);
        t = lever * (frame * t);
        append(t, RowKind::joint, error);
    }
    push_held({rows.last(2), pair, lever, dt}, correction_, [&] { return rates_about(axes); });
    const Vector3 axis = lever * (frame * hinge.axis);
    const double phi = needs_angle(joint) ? angle_near(index, pair) : 0.0;
    if (hinge.motor) append_motor(index, pair, dt, phi, rows);
    if (!has_limit_rows(hinge)) return;
    if (!(hinge.limits->low < hinge.limits->high)) {
        append(axis, RowKind::limit, lever * (phi - hinge.limits->low));
        push_held({rows.last(1), pair, lever, dt}, correction_, [&] { return rates_about(std::span(&axis, 1)); });
        return;
    }
    for (const double side : {1.0, -1.0}) {
        const double gap = lever * gap_to(*hinge.limits, side, phi);
        const Vector3 outwards = side * axis;
        ConstraintRow& row = append(outwards, RowKind::limit, gap);
        row.bounds.c_min = 0.0;
        if (gap > 0.0) {  // it has not reached its limit yet
            row.push.lasting = -gap / dt;
            row.correction = &correction_;
        } else {
            push_held({rows.last(1), pair, lever, dt}, correction_,
                      [&] { return rates_about(std::span(&outwards, 1)); });
        }
    }
}

void JointConstraints::append_motor(std::size_t index, const BodyPair& pair, double dt, double angle,
                                    RowList& rows) const {
    const Hinge& hinge = *items_[index].hinge;
    const Motor& motor = *hinge.motor;
    const double lever = lever_of(pair);
    ConstraintRow& row = append_turn(pair, lever * (pair.body_a.orientation * hinge.axis), rows);
    row.label = {
        .kind = motor.servo ? RowKind::spring : RowKind::motor, .point = static_cast<int>(index), .gap = 0.0};
    if (const auto& servo = motor.servo) {
        const double mobility = 1.0 / (servo->stiffness * dt + servo->damping);  // rad/(N m s)
        row.push.lasting = -lever * servo->stiffness * (angle - servo->angle) * mobility;
        row.softness = lever * lever * mobility / dt;
        return;
    }
    row.push.lasting = lever * motor.speed;
    row.bounds = {.c_min = -motor.max_torque / lever, .c_max = motor.max_torque / lever};
    if (!hinge.limits) return;
    const double side = motor.speed < 0.0 ? 1.0 : -1.0;
    const double gap = lever * gap_to(*hinge.limits, side, angle);
    if (gap > 0.0) {
        row.push.lasting = -side * std::min(lever * std::abs(motor.speed), gap / dt);
    } else {
        const PushFactor back = correct(correction_, -gap, dt);
        row.push = {.correcting = side * back.correcting, .lasting = side * back.lasting};
    }
}

// phi: that of the possible angles which is nearest to the last one known; at first, to the middle of the limits.
double JointConstraints::angle_near(std::size_t index, const BodyPair& pair) const {
    const Hinge& hinge = *items_[index].hinge;
    double near = angles_[index];
    if (std::isnan(near)) near = hinge.limits ? 0.5 * (hinge.limits->low + hinge.limits->high) : 0.0;
    return near + std::remainder(twist(turn_of(items_[index], pair), hinge.axis) - near, 2.0 * std::numbers::pi);
}

double JointConstraints::stored_energy(std::span<const Body> bodies) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < items_.size(); ++i) {
        if (!items_[i].hinge || !items_[i].hinge->motor || !items_[i].hinge->motor->servo) continue;
        const Servo& servo = *items_[i].hinge->motor->servo;
        const double error = angle_near(i, pair_of(items_[i], bodies)) - servo.angle;
        sum += 0.5 * servo.stiffness * error * error;
    }
    return sum;
}

// A ball joint at the centre of a body does not see it turn.
bool JointConstraints::turns_unseen(int body) const {
    return std::none_of(items_.begin(), items_.end(), [body](const Joint& joint) {
        const auto sees = [&](int own, const Vector3& point) {
            return own == body && (joint.hinge || !point.isZero(0.0));
        };
        return sees(joint.body_a, joint.point_a) || sees(joint.body_b, joint.point_b);
    });
}

void JointConstraints::set_angles(std::vector<double> angles) {
    assert(angles.size() == items_.size());
    angles_ = std::move(angles);
}

}  // namespace pushfactor::engine
