#include "engine/constraints/carried.h"

#include "engine/bodies/integrator.h"

#include <algorithm>

namespace pushfactor::engine {

namespace {

// alpha e + (1 - alpha) w x v dt / 2.
Vector3 while_turning(const Vector3& w, const Vector3& r, const Vector3& v, const Body& other, bool along_normal,
                      double dt) {
    const Vector3 beside = along_normal ? Vector3(Vector3::Zero()) : Vector3(0.5 * dt * w.cross(v));
    const double spin = w.norm(), speed = w.cross(r).norm();
    const double other_spin = (angular_velocity(other) - w).norm();
    if (other_spin >= spin || speed == 0.0) return beside;
    const Quaternion turn = exponential(dt * w);
    const Vector3 relative = v - (r - turn.conjugate() * r) / dt;
    const double share = 1.0 - std::max(relative.norm() / speed, other_spin / spin);
    if (share <= 0.0) return beside;
    const Vector3 along = (turn * r - r) / dt - w.cross(r) + 0.5 * dt * w.cross(relative);
    return share * along + (1.0 - share) * beside;
}

// Velocities of `other` going along with `moved`.
Motion carry(const Body& moved, const Body& other, bool along_normal, double dt) {
    const auto& [velocity, w] = moved.prescribed;
    if (w.isZero(0.0)) return moved.prescribed;
    const Vector3 r = other.position - moved.position;
    return {
        velocity + w.cross(r) + while_turning(w, r, engine::velocity(other) - velocity, other, along_normal, dt),
        w};
}

// Rows without a label count as contact rows, but only those of contacts just push.
bool is_normal(const ConstraintRow& row) {
    return row.label.kind == RowKind::contact && row.bounds.c_min == 0.0;
}

}  // namespace

double carried_speed(const ConstraintRow& row, const Body& body_a, const Body& body_b, double dt) {
    const auto along = [&](const Vector6& axis, const Body& moved, const Body& other) {
        const Motion motion = carry(moved, other, is_normal(row), dt);
        return axis.dot(stacked(motion.velocity, motion.angular_velocity));
    };
    if (body_a.is_moved()) return along(row.jacobian.b, body_a, body_b);
    return body_b.is_moved() ? along(row.jacobian.a, body_b, body_a) : 0.0;
}

void carried_speeds(std::span<const Body> bodies, double dt, std::span<const ConstraintRow> rows,
                    std::vector<double>& speeds) {
    for (std::size_t j = speeds.size(); j < rows.size(); ++j) {
        const ConstraintRow& row = rows[j];
        speeds.push_back(carried_speed(row, bodies[static_cast<std::size_t>(row.body_a)],
                                       bodies[static_cast<std::size_t>(row.body_b)], dt));
    }
}

}  // namespace pushfactor::engine
