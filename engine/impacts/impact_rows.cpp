#include "engine/impacts/impact_rows.h"

#include <algorithm>

namespace pushfactor::engine {

namespace {

// Sliding as a share of the velocity of the impact that is more than rounding.
constexpr double has_direction = 1e-9;

}  // namespace

void append_impact_rows(const ContactConstraints& contacts, const collision::Touch& touch, const BodyPair& bodies,
                        const ImpactTime& when, RowList& rows) {
    const auto fall = [](const Body& body) { return body.inverse_mass * body.force.norm(); };
    const Vector3 belt = contacts.belt_of(touch, bodies, when.time);
    const RelativeMotion motion(bodies, motion_of(bodies.body_a), motion_of(bodies.body_b), belt);
    const Vector3 resting = collision::tangent_fixed_in(bodies.body_a.orientation.toRotationMatrix(), touch.normal);
    FrictionBound bound;
    if (contacts.friction()) {
        bound = contacts.friction()->bound({.bodies = bodies,
                                            .normal = touch.normal,
                                            .friction = touch.friction,
                                            .points = static_cast<int>(touch.points.size()),
                                            .size = touch.size,
                                            .acceleration = std::max(fall(bodies.body_a), fall(bodies.body_b)),
                                            .dt = when.dt});
        if (!bound.of_normal_force) bound.limit *= when.dt;
    }
    for (const collision::ContactPoint& point : touch.points) {
        const PairPoint at(bodies, point.position);
        const auto normal_row = static_cast<int>(rows.size());
        ConstraintRow& normal = rows.emplace_back();
        at.place(normal, touch.normal);
        normal.bounds.c_min = 0.0;
        normal.label = {.kind = RowKind::contact, .point = 0, .gap = 0.0};
        if (!contacts.friction()) continue;
        const Vector3 relative =
            velocity_at(bodies.body_b, point.position) - velocity_at(bodies.body_a, point.position);
        const double least = std::max(bound.least_sliding, has_direction * (relative - belt).norm());
        const auto tangents =
            friction_tangents(touch.normal, motion.sliding(point.position, touch.normal), least, resting);
        for (const Disc which : {Disc::first, Disc::second}) {
            const Vector3& tangent = tangents[which == Disc::first ? 0 : 1];
            write_friction_row(at, tangent, bound.at(normal_row, which), tangent.dot(belt), rows.emplace_back());
        }
    }
}

}  // namespace pushfactor::engine
