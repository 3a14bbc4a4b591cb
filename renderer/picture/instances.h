#pragma once

#include "renderer/meshes/instanced_mesh.h"
#include "renderer/picture/picture.h"

#include <span>
#include <vector>

namespace pushfactor::renderer {

// Shader data of the boxes, in the same order.
std::vector<Instance> box_instances(std::span<const Box> boxes);

// The same for spheres.
std::vector<Instance> sphere_instances(std::span<const Sphere> spheres);

// The same for polyhedra.
std::vector<Instance> polyhedron_instances(std::span<const Polyhedron> polyhedra);

// The same for bars, along their y axes: half extents are {radius, half length with the round ends, radius}.
std::vector<Instance> bar_instances(std::span<const Bar> bars);

// A square of the ground below `centre` that extends `half_side` m to each side.
Instance ground_instance(const Ground& ground, const glm::vec3& centre, float half_side);

// How far a body can darken the ground around the point below it, m.
float contact_reach(const Instance& body);

// Bodies close enough to the ground to darken it.
std::vector<Instance> touching(const Ground& ground, std::span<const Instance> bodies);

}  // namespace pushfactor::renderer
