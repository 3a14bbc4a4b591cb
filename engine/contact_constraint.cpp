#include "engine/contact_constraint.h"

#include "engine/point_jacobian.h"

#include <algorithm>

namespace pushfactor::engine {

namespace {

PushFactor contact_push(double gap, const Correction& correction, double slop, double dt) {
    if (gap > 0.0) return {.correcting = 0.0, .lasting = -gap / dt};
    return correct(correction, std::max(0.0, -gap - slop), dt);
}

}  // namespace

Jacobian point_jacobian(const BodyPair& bodies, const Vector3& point, const Vector3& direction) {
    return {.a = point_axis(bodies.body_a, point, -direction), .b = point_axis(bodies.body_b, point, direction)};
}

ConstraintRow contact_row(const BodyPair& bodies, const Vector3& normal, const collision::ContactPoint& point,
                          const Correction& correction, double slop, double dt) {
    ConstraintRow row;
    row.body_a = bodies.a;
    row.body_b = bodies.b;
    row.jacobian = point_jacobian(bodies, point.position, normal);
    row.push = contact_push(point.gap, correction, slop, dt);
    row.bounds.c_min = 0.0;
    row.label = {.kind = RowKind::contact, .point = 0, .gap = point.gap};
    return row;
}

}  // namespace pushfactor::engine
