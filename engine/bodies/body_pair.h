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

// How a body turns while nothing acts on it, world frame: l = I w stays, and I turns with the body.
struct FreeTurn {
    Vector3 w;             // rad/s
    Vector3 acceleration;  // w' [rad/s^2]

    explicit FreeTurn(const Body& body) : w(body.prescribed.angular_velocity), acceleration(Vector3::Zero()) {
        if (body.is_static()) return;
        const Vector3 l = body.orientation.conjugate() * body.angular_momentum;
        const Vector3 own = l.cwiseProduct(body.inverse_inertia);
        w = body.orientation * own;
        acceleration = body.orientation * Vector3(l.cross(own).cwiseProduct(body.inverse_inertia));
    }
};

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
        const FreeTurn turn(body);
        const Vector3 r = point - body.position, along = turn.w.cross(r);
        velocity = engine::velocity(body) + along;
        acceleration = turn.w.cross(along) + turn.acceleration.cross(r);
    }
};

}  // namespace pushfactor::engine
