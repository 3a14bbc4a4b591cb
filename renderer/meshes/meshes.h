#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace pushfactor::renderer {

// A vertex of a shape without a size. An instance with half extents h and bevel b puts it at
// `corner * (h - b) + normal * b` in its own frame: one mesh serves all sizes, with edges of even width.
struct Vertex {
    glm::vec3 corner;  // each component -1, 0 or 1; all 0 in a dome, which is nothing but bevel
    glm::vec3 normal;  // unit length
};

// Triangles, counter-clockwise seen from outside.
struct Mesh {
    std::vector<Vertex> vertices;
    std::vector<std::uint16_t> indices;
};

// A box: 6 faces, 12 bevelled edges and 8 corners. Normals run smoothly over the bevels.
Mesh box_mesh();

// The half of a unit sphere in which z >= 0, without a bottom: `rings` rings of vertices, the lowest on the rim,
// of `sides` vertices each, and one vertex on top.
Mesh dome_mesh(int sides, int rings);

// A horizontal square that faces up.
Mesh square_mesh();

}  // namespace pushfactor::renderer
