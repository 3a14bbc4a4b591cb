#include "engine/bodies/motion.h"

#include <cmath>

namespace pushfactor::engine {

namespace {

constexpr double smallest_angle = 1e-3, largest_angle = 3.0;  // rad per step

}  // namespace

Motion motion_in_step(const Body& body, double dt, OrientationStep rotate, const Vector6& constraint_force) {
    Motion motion = motion_of(body, dt, constraint_force);
    const Vector3& moments = body.inverse_inertia;
    if (moments.minCoeff() == moments.maxCoeff()) return motion;  // as static bodies, cubes and balls
    const double angle = dt * motion.angular_velocity.norm();
    // The axes agree to the square of a small angle; and of more than half a turn the shorter way is the wrong one.
    if (angle < smallest_angle || angle > largest_angle) return motion;
    const Vector3 l = body.angular_momentum + dt * (body.torque + constraint_force.tail<3>());
    Quaternion turn = rotate(body, l, dt) * body.orientation.conjugate();
    if (turn.w() < 0.0) turn.coeffs() = -turn.coeffs();
    const double sine = turn.vec().norm();
    motion.angular_velocity = (2.0 * elementary::atan2(sine, turn.w()) / (sine * dt)) * turn.vec();
    return motion;
}

}  // namespace pushfactor::engine
