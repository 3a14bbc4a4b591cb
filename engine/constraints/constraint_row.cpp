#include "engine/constraints/constraint_row.h"

#include "engine/bodies/body.h"

namespace pushfactor::engine {

namespace {

// Share of its A_jj that the softness of a row is. Modes of the loop that are softer still, where bars fold onto
// each other, count as none; a bridge of twelve planks sags by 3e-5 m.
constexpr double softness_in_loops = 1e-4;

// j_c M^-1 j_c^T of one body [1/kg].
double mobility_along(const Body& body, const Vector6& axis) {
    const Vector3 turning = body.orientation.conjugate() * axis.tail<3>();
    return body.inverse_mass * axis.head<3>().squaredNorm() + turning.cwiseAbs2().dot(body.inverse_inertia);
}

}  // namespace

void soften(const Body& a, const Body& b, ConstraintRow& row) {
    row.softness = softness_in_loops * (mobility_along(a, row.jacobian.a) + mobility_along(b, row.jacobian.b));
}

bool is_of_loop(const ConstraintRow& row) {
    if (!(row.softness > 0.0)) return false;
    return row.label.kind == RowKind::joint || row.label.kind == RowKind::limit ||
           row.label.kind == RowKind::contact;
}

}  // namespace pushfactor::engine
