// Triangles of bodies and marks as glTF stores them: the renderer's meshes at their size.
#pragma once

#include "demos/pictures/to_glm.h"
#include "renderer/meshes/convex_shape.h"

#include <cstdint>
#include <vector>

namespace pushfactor::demos::pictures::gltf {

// Triangles, counter-clockwise seen from outside. Each part has a material of its own.
struct Geometry {
    std::vector<glm::vec3> positions{};               // m, body frame
    std::vector<glm::vec3> normals{};                 // unit length
    std::vector<std::vector<std::uint16_t>> parts{};  // corners of triangles; an index is at most 65534
};

// A box with bevelled edges, as wide as the renderer's.
Geometry box(const glm::vec3& half_extents);

// A unit ball. The first part has the light octants, the second the dark ones.
Geometry ball();

// A convex shape with bevelled edges, as wide as the renderer's.
Geometry polyhedron(const renderer::ConvexShape& shape);

// A cylinder of radius 1 along the y axis, from -1 to 1.
Geometry rod();

// From the origin to (0, 1, 0), for a uniform scale.
Geometry arrow();

// A flat convex polygon, visible from the side from which `corners` [m] run counter-clockwise.
Geometry polygon(const std::vector<engine::Vector3>& corners);

}  // namespace pushfactor::demos::pictures::gltf
