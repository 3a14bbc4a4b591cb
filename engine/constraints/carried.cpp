#include "engine/constraints/carried.h"

#include "engine/bodies/integrator.h"

namespace pushfactor::engine {

Motion carry(const Body& moved, const Body& other, double dt) {
    const auto& [velocity, angular_velocity] = moved.prescribed;
    if (angular_velocity.isZero(0.0)) return moved.prescribed;
    const Vector3 r = other.position - moved.position;
    const Quaternion turn = exponential(dt * angular_velocity);
    const Vector3 along = velocity + (turn * r - r) / dt;
    const Vector3 relative = engine::velocity(other) - velocity - (r - turn.conjugate() * r) / dt;
    return {along + 0.5 * dt * angular_velocity.cross(relative), angular_velocity};
}

double carried_speed(const Jacobian& jacobian, const Body& body_a, const Body& body_b, double dt) {
    const auto along = [dt](const Vector6& axis, const Body& moved, const Body& other) {
        const Motion motion = carry(moved, other, dt);
        return axis.dot(stacked(motion.velocity, motion.angular_velocity));
    };
    if (body_a.is_moved()) return along(jacobian.b, body_a, body_b);
    return body_b.is_moved() ? along(jacobian.a, body_b, body_a) : 0.0;
}

void carried_speeds(std::span<const Body> bodies, double dt, std::span<const ConstraintRow> rows,
                    std::vector<double>& speeds) {
    for (std::size_t j = speeds.size(); j < rows.size(); ++j) {
        const ConstraintRow& row = rows[j];
        speeds.push_back(carried_speed(row.jacobian, bodies[static_cast<std::size_t>(row.body_a)],
                                       bodies[static_cast<std::size_t>(row.body_b)], dt));
    }
}

}  // namespace pushfactor::engine
