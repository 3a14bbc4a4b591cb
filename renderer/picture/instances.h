#pragma once

#include "renderer/meshes/instanced_mesh.h"
#include "renderer/picture/picture.h"

#include <span>
#include <vector>

namespace pushfactor::renderer {

// The boxes as the shaders want them, in the same order.
std::vector<Instance> box_instances(std::span<const Box> boxes);

// The spheres likewise.
std::vector<Instance> sphere_instances(std::span<const Sphere> spheres);

// The bars likewise, along their y axes: half extents are {radius, half length with the round ends, radius}.
std::vector<Instance> bar_instances(std::span<const Bar> bars);

// A piece of the ground below `centre` that reaches `half_side` m to each side.
Instance ground_instance(const Ground& ground, const glm::vec3& centre, float half_side);

// How far a body can darken the ground to each side of the point below it, m.
float contact_reach(const Instance& body);

// Those bodies that are near enough to the ground to darken it.
std::vector<Instance> touching(const Ground& ground, std::span<const Instance> bodies);

}  // namespace pushfactor::renderer
