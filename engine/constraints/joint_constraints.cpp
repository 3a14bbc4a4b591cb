#include "engine/constraints/joint_constraints.h"

#include "engine/base/index.h"
#include "engine/constraints/carried.h"
#include "engine/constraints/point_jacobian.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>

namespace pushfactor::engine {

namespace {

BodyPair pair_of(const Joint& joint, std::span<const Body> bodies) {
    return {joint.body_a, joint.body_b, bodies[at(joint.body_a)], bodies[at(joint.body_b)]};
}

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
    return turn.w() < 0.0 ? 2.0 * std::atan2(-along, -turn.w()) : 2.0 * std::atan2(along, turn.w());
}

// theta: the shortest rotation from `axis` to `other`, both of unit length.
Vector3 rotation_between(const Vector3& axis, const Vector3& other) {
    const Vector3 across = axis.cross(other);
    const double sine = across.norm(), cosine = axis.dot(other);
    if (sine > 0.0) return std::atan2(sine, cosine) / sine * across;
    return cosine < 0.0 ? Vector3(std::numbers::pi * axis.unitOrthogonal()) : Vector3(Vector3::Zero());
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

Span span_of(const Joint& joint, const BodyPair& bodies) {
    const Body &a = bodies.body_a, &b = bodies.body_b;
    return {a.position + a.orientation * joint.point_a, b.position + b.orientation * joint.point_b};
}

}  // namespace

Span span_of(const Joint& joint, std::span<const Body> bodies) {
    return span_of(joint, pair_of(joint, bodies));
}

double angle_of(const Joint& joint, std::span<const Body> bodies) {
    return twist(turn_of(joint, pair_of(joint, bodies)), joint.hinge->axis);
}

std::size_t row_count(const Joint& joint) {
    if (!joint.hinge) return 3;
    const auto& limits = joint.hinge->limits;
    return 5u + (joint.hinge->motor ? 1 : 0) + (!limits ? 0 : limits->low < limits->high ? 2 : 1);
}

JointConstraints::JointConstraints(std::vector<Joint> joints, const Correction& correction, bool cached)
    : joints_(std::move(joints)),
      correction_(correction),
      cached_(cached),
      forces_(joints_.size()),
      acting_(joints_.size()) {
    std::iota(acting_.begin(), acting_.end(), 0);
}

void JointConstraints::append_rows(const StepStart& step, RowList& rows) {
    for (const std::size_t i : acting_) append_rows_of(i, pair_of(joints_[i], step.bodies), step.dt, rows);
}

void JointConstraints::append_rows_of(std::size_t index, const BodyPair& bodies, double dt, RowList& rows) const {
    const Joint& joint = joints_[index];
    const std::size_t first = rows.size();
    const auto [p_a, p_b] = span_of(joint, bodies);
    append_point_rows(bodies, p_a, p_b, correction_, dt, rows);
    for (std::size_t j = first; j < rows.size(); ++j) {
        rows[j].label = {.kind = RowKind::joint, .point = static_cast<int>(index), .gap = (p_b - p_a).norm()};
    }
    if (joint.hinge) append_hinge(index, bodies, dt, rows);
    assert(rows.size() - first == row_count(joint));
    for (std::size_t j = first; cached_ && j < rows.size(); ++j) rows[j].guess = forces_[index][j - first];
}

void JointConstraints::append_hinge(std::size_t index, const BodyPair& pair, double dt, RowList& rows) const {
    const Joint& joint = joints_[index];
    const Hinge& hinge = *joint.hinge;
    const double lever = lever_of(pair);
    const Quaternion turn = turn_of(joint, pair), &frame = pair.body_a.orientation;
    const auto label = [index](RowKind kind, double gap) {
        return RowLabel{.kind = kind, .point = static_cast<int>(index), .gap = gap};
    };

    const Vector3 theta = rotation_between(hinge.axis, turn * hinge.axis);
    const Vector3 across = hinge.axis.unitOrthogonal();
    for (const Vector3& t : {across, Vector3(hinge.axis.cross(across))}) {
        const double error = lever * theta.dot(t);
        ConstraintRow& row = append_turn(pair, lever * (frame * t), rows);
        row.push = correct(correction_, -error, dt);
        row.error = error;
        row.correction = &correction_;
        row.label = label(RowKind::joint, error);
    }
    const Vector3 axis = lever * (frame * hinge.axis);
    if (hinge.motor) {
        ConstraintRow& row = append_turn(pair, axis, rows);
        row.push.lasting = lever * hinge.motor->speed;
        row.bounds = {.c_min = -hinge.motor->max_torque / lever, .c_max = hinge.motor->max_torque / lever};
        row.label = label(RowKind::motor, 0.0);
    }
    if (!hinge.limits) return;
    // From the middle between them, so that the jump of a full turn is as far from both as it can be.
    const double middle = 0.5 * (hinge.limits->low + hinge.limits->high);
    const double half = 0.5 * (hinge.limits->high - hinge.limits->low);
    const double phi = std::remainder(twist(turn, hinge.axis) - middle, 2.0 * std::numbers::pi);
    if (!(half > 0.0)) {
        ConstraintRow& row = append_turn(pair, axis, rows);
        row.push = correct(correction_, -lever * phi, dt);
        row.error = lever * phi;
        row.correction = &correction_;
        row.label = label(RowKind::limit, lever * phi);
        return;
    }
    for (const double side : {1.0, -1.0}) {
        const double gap = lever * (half + side * phi);
        ConstraintRow& row = append_turn(pair, side * axis, rows);
        row.push = gap > 0.0 ? PushFactor{.correcting = 0.0, .lasting = -gap / dt} : correct(correction_, -gap, dt);
        row.bounds.c_min = 0.0;
        row.error = gap;
        row.correction = &correction_;
        row.label = label(RowKind::limit, gap);
    }
}

// A ball joint at the centre of a body does not see it turn.
bool JointConstraints::turns_unseen(int body) const {
    return std::none_of(joints_.begin(), joints_.end(), [body](const Joint& joint) {
        const auto sees = [&](int own, const Vector3& point) {
            return own == body && (joint.hinge || !point.isZero(0.0));
        };
        return sees(joint.body_a, joint.point_a) || sees(joint.body_b, joint.point_b);
    });
}

void JointConstraints::leave_out_others(std::span<const Body> bodies, const Awake& awake) {
    acting_.clear();
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        if (is_any_moving(bodies, awake, joints_[i].body_a, joints_[i].body_b)) acting_.push_back(i);
    }
}

SomeBodies JointConstraints::met_by_moved(const StepStart& step) const {
    return held_by_moved(joints_, step.bodies);
}

void JointConstraints::set_forces(std::vector<JointForce> forces) {
    assert(forces.size() == joints_.size());
    forces_ = std::move(forces);
}

void JointConstraints::remember(std::span<const Lambda> answers) {
    for (const std::size_t i : acting_) {
        const std::size_t rows = row_count(joints_[i]);
        std::copy_n(answers.begin(), rows, forces_[i].begin());
        answers = answers.subspan(rows);
    }
}

}  // namespace pushfactor::engine
