// Rigid bodies, paper section 3.1.
//
// Symbols: m mass [kg], I inertia tensor [kg m^2], x position of the centre of mass [m], o orientation [1],
// p linear momentum [kg m/s], l angular momentum [kg m^2/s], f force [N], tau torque [N m].
//
// Deviations from the paper: "at least a non-zero diagonal" is not enough for I. It is positive definite and
// stored as its three principal moments, so the axes of the body frame are the principal axes. [l] = [p] x [r]
// is about units; the angular momentum of a point is r x p.
#pragma once

#include "engine/base/math.h"

#include <span>

namespace pushfactor::engine {

struct Motion {
    Vector3 velocity = Vector3::Zero();          // m/s, world frame
    Vector3 angular_velocity = Vector3::Zero();  // rad/s, world frame

    bool is_none() const { return velocity.isZero(0.0) && angular_velocity.isZero(0.0); }
};

struct Body {
    // Constants. A static body has both inverses zero: no force moves it.
    double inverse_mass = 0.0;                  // 1/kg
    Vector3 inverse_inertia = Vector3::Zero();  // 1/(kg m^2), principal moments, body frame

    // State, world frame.
    Vector3 position = Vector3::Zero();               // m
    Quaternion orientation = Quaternion::Identity();  // body to world, unit length
    Vector3 linear_momentum = Vector3::Zero();        // kg m/s
    Vector3 angular_momentum = Vector3::Zero();       // kg m^2/s, about the centre of mass

    // Sum of the force sources in this step, world frame.
    Vector3 force = Vector3::Zero();   // N, at the centre of mass
    Vector3 torque = Vector3::Zero();  // N m, about the centre of mass

    // Of a static body with a path (path.h): mean velocities in this step. Zero for all other bodies.
    Motion prescribed{};

    bool is_static() const { return inverse_mass == 0.0; }
    bool is_moved() const { return is_static() && !prescribed.is_none(); }
    double mass() const { return 1.0 / inverse_mass; }  // kg, infinite for a static body
};

Body static_body(const Vector3& position, const Quaternion& orientation = Quaternion::Identity());

// Allowed range of masses [kg] and lengths [m] of movable bodies. Within it the moments of inertia and their
// inverses are finite.
inline constexpr double least_mass = 1e-100, greatest_mass = 1e100;
inline constexpr double least_length = 1e-50, greatest_length = 1e50;

// A movable homogeneous ball of `mass` [kg] and `radius` [m]. Throws InvalidInput like box_body.
Body ball_body(double mass, double radius, const Vector3& position,
               const Quaternion& orientation = Quaternion::Identity());

// A movable homogeneous box of `mass` [kg] and edge lengths `size` [m]. Throws InvalidInput outside the limits
// above.
Body box_body(double mass, const Vector3& size, const Vector3& position,
              const Quaternion& orientation = Quaternion::Identity());

// A movable solid of `mass` [kg] with the principal moments `moments` [m^2, per unit of mass, body frame]. Throws
// InvalidInput for a mass outside the limits above, and for moments that are not positive and finite.
Body solid_body(double mass, const Vector3& moments, const Vector3& position,
                const Quaternion& orientation = Quaternion::Identity());

Vector3 velocity(const Body& body);          // m/s, world frame: p / m; of a static body the prescribed one
Vector3 angular_velocity(const Body& body);  // rad/s, world frame: I^-1 l; the same
// kg m^2/s, world frame: I w, with the angular velocity w [rad/s].
Vector3 angular_momentum_of(const Body& body, const Vector3& angular_velocity);
Matrix3 world_inverse_inertia(const Body& body);  // 1/(kg m^2), world frame: R I^-1 R^T
Matrix3 world_inertia(const Body& body);          // kg m^2, world frame

// Velocity [m/s] of the material point of `body` at `point` [m], both in the world frame.
Vector3 velocity_at(const Body& body, const Vector3& point);

}  // namespace pushfactor::engine
