// Two bodies that rows act between, and how they part while nothing acts on them.
#pragma once

#include "engine/bodies/body.h"

namespace pushfactor::engine {

struct BodyPair {
    int a = 0;  // indices into the bodies of the world
    int b = 0;
    const Body& body_a;
    const Body& body_b;
};

// w' of a body that nothing turns [rad/s^2], world frame: l = I w stays, and I turns with the body.
inline Vector3 free_angular_acceleration(const Body& body) {
    return world_inverse_inertia(body) * body.angular_momentum.cross(angular_velocity(body));
}

// Velocity [m/s] and acceleration [m/s^2] of a point of b less those of a point of a, world frame.
struct Parting {
    Vector3 velocity, acceleration;

    Parting(const BodyPair& bodies, const Vector3& on_a, const Vector3& on_b) : Parting(bodies.body_b, on_b) {
        const Parting of_a(bodies.body_a, on_a);
        velocity -= of_a.velocity;
        acceleration -= of_a.acceleration;
    }

  private:
    Parting(const Body& body, const Vector3& point) {
        const Vector3 r = point - body.position, w = angular_velocity(body), along = w.cross(r);
        velocity = engine::velocity(body) + along;
        acceleration = w.cross(along) + free_angular_acceleration(body).cross(r);
    }
};

}  // namespace pushfactor::engine
