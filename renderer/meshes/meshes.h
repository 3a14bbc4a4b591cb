#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace pushfactor::renderer {

// A size-independent vertex. An instance with half extents h and bevel b places it at `corner * (h - b) + normal *
// b` in its own frame: one mesh serves all sizes, with edges of constant width.
struct Vertex {
    glm::vec3 corner;  // each component -1, 0 or 1; all 0 in a dome, which is all bevel
    glm::vec3 normal;  // unit length
};

// Triangles, counter-clockwise seen from outside.
struct Mesh {
    std::vector<Vertex> vertices;
    std::vector<std::uint16_t> indices;
};

// A box: 6 faces, 12 bevelled edges and 8 corners. Normals are interpolated over the bevels.
Mesh box_mesh();

// Half of a unit sphere, z >= 0, without a base: `rings` rings of `sides` vertices each, the lowest on the rim, and
// one vertex on top.
Mesh dome_mesh(int sides, int rings);

// A horizontal square that faces up.
Mesh square_mesh();

}  // namespace pushfactor::renderer
