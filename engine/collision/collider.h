// The shapes that bodies collide with, paper section 4.
#pragma once

#include "engine/base/math.h"
#include "engine/bodies/body.h"

#include <limits>
#include <variant>

namespace pushfactor::engine::collision {

// Axes along the body frame, centred on the body's position.
struct Box {
    Vector3 half_size = Vector3::Constant(0.5);  // m
};

// Centred on the body's position.
struct Sphere {
    double radius = 0.5;  // m
};

// Infinite: the points below the plane through the body's position with the body frame's y axis as its normal.
// Only for static bodies.
struct Plane {};

// The order of the alternatives is the order of the pair table.
using Shape = std::variant<Box, Sphere, Plane>;

struct Collider {
    int body = 0;  // index into the bodies of the world
    Shape shape;
    double friction = 0.5;     // mu >= 0; a pair has the root of the product
    double restitution = 0.0;  // epsilon 0..1; a pair has the larger
    // How fast the surface itself runs, as a conveyor belt does [m/s, body frame]; friction drives with it.
    Vector3 surface_velocity = Vector3::Zero();
    double surface_from = 0.0;  // s since the start of the world, from when on it runs
};

// Whether its surface runs in a step that begins at `time` [s].
bool runs_at(const Collider& collider, double time);

// Where a body is: maps its frame to the world.
struct Pose {
    Vector3 position;  // m
    Matrix3 rotation;
};
Pose pose_of(const Body& body);

// The length that slop, margin and tolerances of a shape are measured in [m]: its shortest edge or its
// diameter; infinite for a plane.
double size_of(const Shape& shape);

// Half the edges of a box around the shape along the world's axes [m]; infinite for a plane.
Vector3 half_extents(const Shape& shape, const Matrix3& rotation);

// How far the shape reaches from its centre along `direction`, times the length of that [m]; infinite for a plane.
double reach_along(const Shape& shape, const Matrix3& rotation, const Vector3& direction);

// How far from its centre the shape has points that turning moves [m^2, squared]; zero for a sphere, which turns in
// itself, and for a plane, which never turns.
double squared_turning_radius(const Shape& shape);

// Whether the shape stays the same however it turns about its centre.
bool turns_in_itself(const Shape& shape);

// Whether the shape has an end in every direction.
bool is_finite(const Shape& shape);

}  // namespace pushfactor::engine::collision
