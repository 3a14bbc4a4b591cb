// j_c of rows that act at a point (paper 5.2.1, 5.3, 5.4).
#pragma once

#include "engine/bodies/body_pair.h"
#include "engine/constraints/constraint_row.h"

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

}  // namespace pushfactor::engine
