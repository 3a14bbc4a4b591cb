#include "engine/constraints/friction_row.h"

#include "engine/base/constants.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine {

FrictionRule weight_friction(const Vector3& gravity) {
    return [gravity](const FrictionSite& site) -> FrictionBound {
        double mass = 0.0;
        for (const Body* body : {&site.bodies.body_a, &site.bodies.body_b}) {
            if (!body->is_static()) mass += body->mass();
        }
        return {.limit = site.friction * mass * std::abs(gravity.dot(site.normal)) / site.points,
                .least_sliding = constants::rows::sliding * site.size / site.dt};
    };
}

FrictionBound coulomb_friction(const FrictionSite& site) {
    return {.limit = site.friction,
            .of_normal_force = true,
            .least_sliding = constants::rows::sliding * std::sqrt(site.size * site.acceleration)};
}

FrictionBound cone_friction(const FrictionSite& site) {
    FrictionBound bound = coulomb_friction(site);
    bound.round = true;
    return bound;
}

RelativeMotion::RelativeMotion(const BodyPair& bodies, const Motion& a, const Motion& b, const Vector3& belt)
    : origin_(bodies.body_a.is_static() ? bodies.body_b.position : bodies.body_a.position) {
    const Vector3 velocity_a = a.velocity + a.angular_velocity.cross(origin_ - bodies.body_a.position);
    const Vector3 velocity_b = b.velocity + b.angular_velocity.cross(origin_ - bodies.body_b.position);
    velocity_ = velocity_b - velocity_a - belt;
    spin_ = b.angular_velocity - a.angular_velocity;
}

Vector3 RelativeMotion::sliding(const Vector3& point, const Vector3& normal) const {
    const Vector3 relative = velocity_ + spin_.cross(point - origin_);
    return relative - normal * normal.dot(relative);
}

std::array<Vector3, 2> friction_tangents(const Vector3& normal, const Vector3& sliding, double least_sliding,
                                         const Vector3& resting) {
    const double square = sliding.squaredNorm();
    if (square <= least_sliding * least_sliding) return {resting, normal.cross(resting)};
    const Vector3 first = sliding / std::sqrt(square);
    return {first, normal.cross(first)};
}

void write_friction_row(const PairPoint& point, const Vector3& tangent, const Bounds& bounds, double speed,
                        ConstraintRow& row) {
    point.place(row, tangent);
    row.push.lasting = speed;
    row.bounds = bounds;
    row.label.kind = RowKind::friction;
}

}  // namespace pushfactor::engine
