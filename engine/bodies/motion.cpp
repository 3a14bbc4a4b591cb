#include "engine/bodies/motion.h"

#include <cmath>
#include <numbers>

namespace pushfactor::engine {

namespace {

constexpr double full_turn = 2.0 * std::numbers::pi;
constexpr double smallest_angle = 1e-3;  // rad per step
constexpr double least_sine = 1e-6;      // of half the angle between the orientations before and after

}  // namespace

Motion motion_in_step(const Body& body, double dt, OrientationStep rotate, const Vector6& constraint_force) {
    Motion motion = motion_of(body, dt, constraint_force);
    const Vector3& moments = body.inverse_inertia;
    if (moments.minCoeff() == moments.maxCoeff()) return motion;  // as static bodies, cubes and balls
    const double angle = dt * motion.angular_velocity.norm();
    // The axes agree to the square of a small angle.
    if (angle < smallest_angle) return motion;
    const Vector3 l = body.angular_momentum + dt * (body.torque + constraint_force.tail<3>());
    Quaternion turn = rotate(body, l, dt) * body.orientation.conjugate();
    if (turn.w() < 0.0) turn.coeffs() = -turn.coeffs();
    const double sine = turn.vec().norm();
    if (sine < least_sine) return motion;  // whole turns
    const Vector3 axis = turn.vec() / sine;
    const double shortest = 2.0 * elementary::atan2(sine, turn.w());
    const Vector3 expected = dt * motion.angular_velocity;
    const double whole = full_turn * std::round((expected.dot(axis) - shortest) / full_turn);
    // A slender body that tumbles as it spins about its length ends as if it had hardly spun.
    const bool spins = (expected - (shortest + whole) * axis).norm() < 0.5 * full_turn;
    motion.angular_velocity = ((shortest + (spins ? whole : 0.0)) / (sine * dt)) * turn.vec();
    return motion;
}

}  // namespace pushfactor::engine
