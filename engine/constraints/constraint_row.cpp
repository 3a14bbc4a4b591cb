#include "engine/constraints/constraint_row.h"

#include "engine/base/constants.h"
#include "engine/bodies/body.h"

namespace pushfactor::engine {

namespace {

// j_c M^-1 j_c^T of one body [1/kg].
double mobility_along(const Body& body, const Vector6& axis) {
    const Vector3 turning = body.orientation.conjugate() * axis.tail<3>();
    return body.inverse_mass * axis.head<3>().squaredNorm() + turning.cwiseAbs2().dot(body.inverse_inertia);
}

}  // namespace

void soften(const Body& a, const Body& b, ConstraintRow& row) {
    row.softness = constants::rows::softness_in_loops *
                   (mobility_along(a, row.jacobian.a) + mobility_along(b, row.jacobian.b));
}

bool is_of_loop(const ConstraintRow& row) {
    if (!(row.softness > 0.0)) return false;
    return row.label.kind == RowKind::joint || row.label.kind == RowKind::limit ||
           row.label.kind == RowKind::contact;
}

}  // namespace pushfactor::engine
