#pragma once

#include "renderer/meshes/instanced_mesh.h"
#include "renderer/picture/picture.h"

#include <cstddef>
#include <span>
#include <vector>

namespace pushfactor::renderer {

// Shader data of a body, the `number`-th of its kind.
Instance instance_of(const Body& body, std::size_t number);

// The same for a bar, along its y axis: half extents are {radius, half length with the round ends, radius}.
Instance instance_of(const Bar& bar, std::size_t number);

// A square of the ground below `centre` that extends `half_side` m to each side.
Instance ground_instance(const Ground& ground, const glm::vec3& centre, float half_side);

// How far a body can darken the ground around the point below it, m.
float contact_reach(const Instance& body);

// Bodies close enough to the ground to darken it.
std::vector<Instance> touching(const Ground& ground, std::span<const Instance> bodies);

}  // namespace pushfactor::renderer
