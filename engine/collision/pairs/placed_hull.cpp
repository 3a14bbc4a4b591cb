#include "engine/collision/pairs/placed_hull.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine::collision {

namespace {

// The cube from -1 to 1, vertices numbered as the corners in plane_pairs.cpp.
const Hull& cube() {
    static const PolyhedronMesh mesh = [] {
        std::vector<Vector3> vertices;
        for (unsigned k = 0; k < 8; ++k) {
            vertices.emplace_back((k & 1u) ? 1.0 : -1.0, (k & 2u) ? 1.0 : -1.0, (k & 4u) ? 1.0 : -1.0);
        }
        return PolyhedronMesh(vertices,
                              {{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3}, {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}});
    }();
    return mesh.hull();
}

}  // namespace

PlacedHull::PlacedHull(const Box& box, const Pose& pose) : hull_(&box_), pose_(pose) {
    const Hull& unit = cube();
    for (std::size_t i = 0; i < 8; ++i) vertices_[i] = unit.vertices[i].cwiseProduct(box.half_size);
    for (std::size_t i = 0; i < 6; ++i) {
        faces_[i] = unit.faces[i];
        faces_[i].offset = faces_[i].normal.cwiseAbs().dot(box.half_size);
    }
    for (std::size_t i = 0; i < 12; ++i) {
        edges_[i] = unit.edges[i];
        edges_[i].length = 2.0 * edges_[i].direction.cwiseAbs().dot(box.half_size);
    }
    const double inner = box.half_size.minCoeff();
    box_ = {.vertices = vertices_,
            .faces = faces_,
            .corners = unit.corners,
            .edges = edges_,
            .size = 2.0 * inner,
            .inner_radius = inner};
}

}  // namespace pushfactor::engine::collision
