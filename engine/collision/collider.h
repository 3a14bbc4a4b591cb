// The shapes that bodies collide with, paper section 4.
#pragma once

#include "engine/body.h"
#include "engine/math.h"

#include <limits>
#include <variant>

namespace pushfactor::engine::collision {

// Axes along the body frame, centred on the body's position.
struct Box {
    Vector3 half_size = Vector3::Constant(0.5);  // m
};

// Infinite: the points below the plane through the body's position with the body frame's y axis as its normal.
// Only for static bodies.
struct Plane {};

// The order of the alternatives is the order of the pair table.
using Shape = std::variant<Box, Plane>;

struct Collider {
    int body = 0;  // index into the bodies of the world
    Shape shape;
    double friction = 0.5;  // mu >= 0; a pair has the root of the product
};

// Where a body is: maps its frame to the world.
struct Pose {
    Vector3 position;  // m
    Matrix3 rotation;
};
Pose pose_of(const Body& body);

// The length that slop, margin and tolerances of a shape are measured in [m]: its shortest edge; infinite for a
// plane.
double size_of(const Shape& shape);

}  // namespace pushfactor::engine::collision
