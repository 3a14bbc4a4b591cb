#pragma once

#include "renderer/meshes/meshes.h"

#include <glm/vec3.hpp>

#include <string>
#include <vector>

namespace pushfactor::renderer {

// A convex solid with the origin inside, in a frame of its own.
struct ConvexShape {
    std::vector<glm::vec3> corners{};       // m
    std::vector<std::vector<int>> faces{};  // loops of corners, counter-clockwise seen from outside

    bool operator==(const ConvexShape&) const = default;
};

// Orders shapes; only equal ones are equivalent.
bool before(const ConvexShape& a, const ConvexShape& b);

// What is wrong with a shape, for a sentence that begins with its name; empty for nothing.
std::string fault_of(const ConvexShape& shape);

// Half of the edges of the box around the origin that holds the shape, m.
glm::vec3 half_extents(const ConvexShape& shape);

// How far a shape is rounded where it darkens the ground, and what its mesh subtracts again: the `bevel` of its
// instances, m.
float roundness(const ConvexShape& shape);

// The shape with bevelled edges, as wide as those of a box, for instances with the half extents and the roundness
// of the shape. The shape must have no fault.
Mesh convex_mesh(const ConvexShape& shape);

}  // namespace pushfactor::renderer
