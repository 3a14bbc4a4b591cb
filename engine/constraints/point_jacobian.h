// j_c of rows that act at a point (paper 5.2.1, 5.3, 5.4).
#pragma once

#include "engine/base/constants.h"
#include "engine/bodies/body.h"
#include "engine/constraints/constraint_row.h"
#include "engine/constraints/row_list.h"

#include <algorithm>

namespace pushfactor::engine {

// Writes [d, r x d] for the direction d = (x, y, z) [1], r the offset from the centre of mass [m], world frame.
// Scalar access on purpose: a 16-byte load after 8-byte stores stalls store forwarding.
inline void place_axis(double x, double y, double z, const Vector3& r, Vector6& axis) {
    axis[0] = x;
    axis[1] = y;
    axis[2] = z;
    axis[3] = r.y() * z - r.z() * y;
    axis[4] = r.z() * x - r.x() * z;
    axis[5] = r.x() * y - r.y() * x;
}

struct BodyPair {
    int a = 0;
    int b = 0;
    const Body& body_a;
    const Body& body_b;
};

// The point at which the bodies of a pair act on each other. Shared by the rows of a contact.
class PairPoint {
  public:
    // One point [m, world frame].
    PairPoint(const BodyPair& bodies, const Vector3& position) : PairPoint(bodies, position, position) {}

    // One point per body [m, world frame].
    PairPoint(const BodyPair& bodies, const Vector3& on_a, const Vector3& on_b)
        : a_(bodies.a),
          b_(bodies.b),
          r_a_(on_a - bodies.body_a.position),
          r_b_(on_b - bodies.body_b.position),
          a_moves_(!bodies.body_a.is_static()),
          b_moves_(!bodies.body_b.is_static()) {}

    // Sets bodies and Jacobian of a new row, j_c of 5.3 for any unit `direction` d: [-d, -r_a x d, d, r_b x d]; the
    // block of a static body is zero (the simplification at the end of 5.3).
    void place(ConstraintRow& row, const Vector3& direction) const {
        row.body_a = a_;
        row.body_b = b_;
        if (a_moves_) place_axis(-direction.x(), -direction.y(), -direction.z(), r_a_, row.jacobian.a);
        if (b_moves_) place_axis(direction.x(), direction.y(), direction.z(), r_b_, row.jacobian.b);
    }

  private:
    int a_, b_;          // indices of the bodies
    Vector3 r_a_, r_b_;  // m, offsets from the centres of mass
    bool a_moves_, b_moves_;
};

// Velocity [m/s] and acceleration [m/s^2] of a point of b less those of a point of a [m], world frame, while both
// bodies keep their velocities.
struct Parting {
    Vector3 velocity, acceleration;

    Parting(const BodyPair& bodies, const Vector3& on_a, const Vector3& on_b) : Parting(bodies.body_b, on_b) {
        const Parting of_a(bodies.body_a, on_a);
        velocity -= of_a.velocity;
        acceleration -= of_a.acceleration;
    }

  private:
    Parting(const Body& body, const Vector3& point) {
        const Vector3 w = angular_velocity(body), along = w.cross(point - body.position);
        velocity = engine::velocity(body) + along;
        acceleration = w.cross(along);
    }
};

// Speed [m/s] up to which a push of a bar or a joint of this `size` [m] is small.
inline double unseen_speed(const BodyPair& bodies, double size, double dt) {
    using constants::collision::meeting_gap, constants::held::share_of_forces;
    const auto acceleration = [](const Body& body) { return body.inverse_mass * body.force.norm(); };
    return share_of_forces * dt * std::max(acceleration(bodies.body_a), acceleration(bodies.body_b)) +
           meeting_gap * size / dt;
}

// kg m^2, world frame.
inline Matrix3 world_inertia(const Body& body) {
    const Matrix3 axes = body.orientation.toRotationMatrix();
    return axes * body.inverse_inertia.cwiseInverse().asDiagonal() * axes.transpose();
}

// Appends three rows, along the world's x, y and z, that hold a point of each body together [m, world frame]: a
// ball joint (5.2 with length 0).
//
// While it is open, force and reaction act at two points, and would turn the pair by a couple. It is taken from
// both bodies as from one piece, so that both get the same angular acceleration; halves, as of forces in the
// middle, would spin a slender bar about itself. A static body takes half: then they act in the middle.
inline void append_point_rows(const BodyPair& bodies, const Vector3& on_a, const Vector3& on_b,
                              const Correction& correction, double dt, RowList& rows) {
    const Vector3 p_ab = on_b - on_a;
    const PairPoint points(bodies, on_a, on_b);
    const bool a_moves = !bodies.body_a.is_static(), b_moves = !bodies.body_b.is_static();
    Matrix3 share_of_a = 0.5 * Matrix3::Identity();
    if (a_moves && b_moves) {
        const Matrix3 inertia = world_inertia(bodies.body_a);
        share_of_a = inertia * (inertia + world_inertia(bodies.body_b)).inverse();
    }
    const bool curves = correction.kind == PushKind::curve;
    const Vector3 curve = curves ? Parting(bodies, on_a, on_b).acceleration : Vector3(Vector3::Zero());
    const double size = (on_a - bodies.body_a.position).norm() + (on_b - bodies.body_b.position).norm();
    const double unseen = unseen_speed(bodies, size, dt);
    for (int axis = 0; axis < 3; ++axis) {
        ConstraintRow& row = rows.emplace_back();
        points.place(row, Vector3::Unit(axis));
        const Vector3 couple = p_ab.cross(Vector3::Unit(axis)), of_a = share_of_a * couple;
        if (a_moves) row.jacobian.a.tail<3>() -= of_a;
        if (b_moves) row.jacobian.b.tail<3>() -= couple - of_a;
        row.push = correct(
            correction, -p_ab[axis], dt, [&] { return curve[axis]; }, unseen);
        row.error = p_ab[axis];
        row.correction = &correction;
    }
}

}  // namespace pushfactor::engine
