// Motion of a body within one step: constant velocities, as in 3.2.3.
#pragma once

#include "engine/bodies/integrator.h"
#include "engine/bodies/path.h"

#include <span>

namespace pushfactor::engine {

inline constexpr double never = infinity;  // s, the time at which a motion gets where it does not go

// Motion with the current momenta.
inline Motion motion_of(const Body& body) {
    return {velocity(body), angular_velocity(body)};
}

// Motion in a step of `dt` [s] with external forces and `constraint_force` (N and N m, world frame).
inline Motion motion_of(const Body& body, double dt, const Vector6& constraint_force = Vector6::Zero()) {
    if (body.is_static()) return body.prescribed;
    const Vector3 force = body.force + constraint_force.head<3>();
    const Vector3 torque = body.torque + constraint_force.tail<3>();
    return {body.inverse_mass * (body.linear_momentum + dt * force),
            world_inverse_inertia(body) * (body.angular_momentum + dt * torque)};
}

// The motion of the body in a step of `dt` [s] that ends where the integrator of 3.2 with `rotate` lets it end: a
// body that tumbles turns about the axis between its orientations before and after.
Motion motion_in_step(const Body& body, double dt, OrientationStep rotate,
                      const Vector6& constraint_force = Vector6::Zero());

// A body whose way through the step has been followed from impact to impact (impacts.h), where it ends if no row
// holds it, and the constant velocities that would take it there.
struct Strayed {
    int body = 0;
    Place end{};
    Motion way{};
};

// Motions of all bodies in a step, by body.
struct StepMotions {
    double dt = 0.0;                  // s
    std::span<const Motion> before;   // with the momenta before the step
    std::span<const Motion> after;    // motion_of() with the forces that act: the velocities that rows know
    std::span<const Motion> paths;    // motion_in_step() with them: where the bodies go
    std::span<const char> strayed{};  // whether the way of the body is in `Strayed`; empty if none is

    bool has_strayed(int body) const { return !strayed.empty() && strayed[static_cast<std::size_t>(body)] != 0; }
    const Motion& path_of(int body) const { return paths[static_cast<std::size_t>(body)]; }
};

}  // namespace pushfactor::engine
