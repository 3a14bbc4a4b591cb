// How a body moves within one step: uniformly, as 3.2.3 takes it from place to place.
#pragma once

#include "engine/bodies/body.h"

namespace pushfactor::engine {

struct Motion {
    Vector3 velocity = Vector3::Zero();          // m/s, world frame
    Vector3 angular_velocity = Vector3::Zero();  // rad/s, world frame
};

// Of `body` as it is.
inline Motion motion_of(const Body& body) {
    return {velocity(body), angular_velocity(body)};
}

// Of `body` in a step of `dt` [s], with its external forces and `constraint_force` (N and N m, world frame).
inline Motion motion_of(const Body& body, double dt, const Vector6& constraint_force = Vector6::Zero()) {
    if (body.is_static()) return {};
    const Vector3 force = body.force + constraint_force.head<3>();
    const Vector3 torque = body.torque + constraint_force.tail<3>();
    return {body.inverse_mass * (body.linear_momentum + dt * force),
            world_inverse_inertia(body) * (body.angular_momentum + dt * torque)};
}

// Whether a body has got another constraint force, and how: as part of an answer for the whole step, or in small
// steps, which stir a heap by more than any answer would be worth for a small part of a size.
enum class NewForce : char { none, of_answer, of_small_steps };

}  // namespace pushfactor::engine
