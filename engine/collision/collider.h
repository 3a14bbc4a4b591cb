// Collision shapes of bodies, paper section 4.
#pragma once

#include "engine/base/math.h"
#include "engine/bodies/body.h"
#include "engine/collision/polyhedron.h"

#include <variant>

namespace pushfactor::engine::collision {

// Axis-aligned in the body frame, centred at the body's position.
struct Box {
    Vector3 half_size = Vector3::Constant(0.5);  // m
};

// Centred at the body's position.
struct Sphere {
    double radius = 0.5;  // m
};

// Infinite half-space below the plane through the body's position whose normal is the body frame's y axis. Only
// for static bodies.
struct Plane {};

using Shape = std::variant<Box, Sphere, Plane, Polyhedron>;

struct Collider {
    int body = 0;  // index into the bodies of the world
    Shape shape;
    double friction = 0.5;     // mu >= 0; combined for a pair as the square root of the product
    double restitution = 0.0;  // epsilon 0..1; a pair has the larger one
    // Surface velocity of a conveyor belt [m/s, body frame]; acts through friction.
    Vector3 surface_velocity = Vector3::Zero();
    double surface_from = 0.0;  // s since the start of the world, when the belt starts
    int material = -1;          // number in MaterialPairs (detector.h); negative: none
};

// Whether the belt runs in a step that begins at `time` [s].
bool runs_at(const Collider& collider, double time);

// Transform from body frame to world.
struct Pose {
    Vector3 position;  // m
    Matrix3 rotation;
};
Pose pose_of(const Body& body);

// Reference length of slop, margin and tolerances [m]: shortest edge or diameter of the shape, of a polyhedron the
// least width across a face; infinite for a plane.
double size_of(const Shape& shape);

// Half the edge lengths of the shape's bounding box about its centre, world axes [m]; infinite for a plane.
Vector3 half_extents(const Shape& shape, const Matrix3& rotation);

// Extent of the shape from its centre along `direction`, times the norm of `direction` [m]; infinite for a plane.
double reach_along(const Shape& shape, const Matrix3& rotation, const Vector3& direction);

// Squared distance from the centre to the farthest point that turning moves [m^2]; zero for spheres, whose surface
// turning does not change, and for planes, which turn only if moved.
double squared_turning_radius(const Shape& shape);

// Whether the shape is invariant under rotation about its centre.
inline bool turns_in_itself(const Shape& shape) {
    return std::holds_alternative<Sphere>(shape);
}

// Whether the shape is bounded.
inline bool is_finite(const Shape& shape) {
    return !std::holds_alternative<Plane>(shape);
}

}  // namespace pushfactor::engine::collision
