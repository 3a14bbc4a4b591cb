#include "engine/friction_constraint.h"

#include <cmath>

namespace pushfactor::engine {

Bounds WeightFriction::bounds(const FrictionSite& site) const {
    double mass = 0.0;
    for (const Body* body : {&site.bodies.body_a, &site.bodies.body_b}) {
        if (!body->is_static()) mass += body->mass();
    }
    const double limit = site.friction * mass * std::abs(gravity_.dot(site.normal)) / site.points;
    return {.c_min = -limit, .c_max = limit};
}

Bounds CoulombFriction::bounds(const FrictionSite& site) const {
    return {.c_min = -site.friction, .c_max = site.friction, .of_row = site.normal_row};
}

Vector3 sliding_velocity(const BodyPair& bodies, const Vector3& point, const Vector3& normal, const Vector3& belt) {
    const Vector3 relative = velocity_at(bodies.body_b, point) - velocity_at(bodies.body_a, point) - belt;
    return relative - normal * normal.dot(relative);
}

std::array<Vector3, 2> friction_tangents(const Body& body_a, const Vector3& normal, const Vector3& sliding,
                                         double least_sliding) {
    const double speed = sliding.norm();
    const Vector3 first = speed > least_sliding
                              ? Vector3(sliding / speed)
                              : collision::tangent_fixed_in(body_a.orientation.toRotationMatrix(), normal);
    return {first, normal.cross(first)};
}

ConstraintRow friction_row(const BodyPair& bodies, const Vector3& point, const Vector3& tangent,
                           const Bounds& bounds, double speed) {
    ConstraintRow row;
    row.body_a = bodies.a;
    row.body_b = bodies.b;
    row.jacobian = point_jacobian(bodies, point, tangent);
    row.push.lasting = speed;
    row.bounds = bounds;
    row.label.kind = RowKind::friction;
    return row;
}

}  // namespace pushfactor::engine
