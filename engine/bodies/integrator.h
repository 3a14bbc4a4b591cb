// The integrator, paper section 3.2: semi-implicit Euler, momenta first, then positions with the new momenta.
//
// Symbols as in body.h; dt time step [s].
//
// Deviation: 3.2.4 does not conserve the energy of a tumbling body. With the inertia at the start of the step
// it drives every free body towards its axis of smallest inertia. The exponential map (12.4.1) removes the
// error of the angle but not that drift; three-axis splitting removes both. All three have one signature, and a
// world holds the one to use.
#pragma once

#include "engine/bodies/body.h"

namespace pushfactor::engine {

// 3.2.1, 3.2.2: p(t+dt) = p(t) + f dt, l(t+dt) = l(t) + tau dt. World frame.
inline Vector3 advance_momentum(const Vector3& momentum, const Vector3& force, double dt) {
    return momentum + force * dt;
}

// 3.2.3: x(t+dt) = x(t) + dt p(t+dt) / m. `linear_momentum` is the new one.
inline Vector3 advance_position(const Body& body, const Vector3& linear_momentum, double dt) {
    return body.position + (body.inverse_mass * dt) * linear_momentum;
}

// 12.4.1: the rotation by `rotation_vector` [rad, world frame].
Quaternion exponential(const Vector3& rotation_vector);

// Orientation after dt [s] of torque-free motion with the (new) `angular_momentum` [kg m^2/s, world frame]. The
// result has unit length.
using OrientationStep = Quaternion (*)(const Body& body, const Vector3& angular_momentum, double dt);

// 3.2.4: o + [0, 1/2 I^-1 l] o dt. The angle per step is 2 atan(|w| dt / 2) instead of |w| dt.
Quaternion rotate_euler(const Body& body, const Vector3& angular_momentum, double dt);

// 12.4.1: exact rotation for a constant angular velocity I^-1 l.
Quaternion rotate_exponential(const Body& body, const Vector3& angular_momentum, double dt);

// Strang splitting of the free rigid body into rotations about its three principal axes, with the axis of
// smallest inertia in the middle. Second order; conserves |l| to rounding and the energy without drift. Bodies
// with two equal moments (spheres and cubes among them) use the closed form: precession about l times spin.
Quaternion rotate_splitting(const Body& body, const Vector3& angular_momentum, double dt);

// rotate_splitting in sub-steps of small angle: at a radian per step it would give a free box energy, and a body
// that bounces at random from bounce to bounce. Not smooth in dt, so not suitable for composing higher-order
// schemes.
Quaternion rotate_by_small_turns(const Body& body, const Vector3& angular_momentum, double dt);

}  // namespace pushfactor::engine
