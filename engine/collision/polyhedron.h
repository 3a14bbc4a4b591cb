// Convex polyhedra as collision shapes, paper section 4: vertices, faces and edges.
#pragma once

#include "engine/base/math.h"

#include <memory>
#include <span>
#include <vector>

namespace pushfactor::engine::collision {

// Limits that the features of contact points rely on: below 1024 edges.
inline constexpr int least_vertices = 4, most_vertices = 256;

struct HullFace {
    Vector3 normal;            // unit length, outward
    double offset = 0.0;       // m, largest of normal . x over all vertices
    int first = 0, count = 0;  // of its corners, see Hull::corners
    // Whether its corners are visited clockwise: opposite faces of a box then have theirs in the same order.
    bool clockwise = false;
};

struct HullEdge {
    int from = 0, to = 0;     // vertices
    int left = 0, right = 0;  // faces, seen from outside along the edge
    Vector3 direction;        // unit length
    double length = 0.0;      // m
    double bulge = 1.0;       // 1 / cos of half the angle between the normals of its faces
};

// A convex polyhedron with the origin inside, body frame. A view: does not own its parts.
struct Hull {
    struct Corner {
        int vertex = 0;
        int edge = 0;  // the one to the next corner
        // Whose corner's edge a clipping of another face to this one takes in the place of this corner's.
        int side = 0;
    };

    std::span<const Vector3> vertices;  // m
    std::span<const HullFace> faces;
    std::span<const Corner> corners;  // of all faces, counter-clockwise seen from outside
    std::span<const HullEdge> edges;
    double size = 0.0;          // m, least width across a face
    double inner_radius = 0.0;  // m, from the origin to the closest face

    std::span<const Corner> corners_of(const HullFace& face) const {
        return corners.subspan(static_cast<std::size_t>(face.first), static_cast<std::size_t>(face.count));
    }
    const Vector3& vertex(int index) const { return vertices[static_cast<std::size_t>(index)]; }
    const HullFace& face(int index) const { return faces[static_cast<std::size_t>(index)]; }
    const HullEdge& edge(int index) const { return edges[static_cast<std::size_t>(index)]; }
};

// The largest of `direction` . x over the vertices.
double support(const Hull& hull, const Vector3& direction);

class PolyhedronMesh {
  public:
    // Vertices [m] in the body frame: the origin is inside. Faces are loops of vertex indices, counter-clockwise
    // seen from outside. Throws InvalidInput unless they are the surface of a convex polyhedron of 4 to 256
    // vertices.
    //
    // The faces are sorted by their directions, x before y before z and + before -, their corners begin with the
    // one farthest along x, y, z, and their sides are sorted by directions too, from the axis after that of the
    // face on: the order of contact points must not depend on the order of the input, and is that of a box
    // (box_box.cpp).
    PolyhedronMesh(std::vector<Vector3> vertices, const std::vector<std::vector<int>>& faces);
    PolyhedronMesh(const PolyhedronMesh&) = delete;
    PolyhedronMesh& operator=(const PolyhedronMesh&) = delete;

    const Hull& hull() const { return hull_; }
    double squared_radius() const { return squared_radius_; }  // m^2, of the farthest vertex

  private:
    std::vector<Vector3> vertices_;
    std::vector<HullFace> faces_;
    std::vector<Hull::Corner> corners_;
    std::vector<HullEdge> edges_;
    Hull hull_;  // of the members above
    double squared_radius_ = 0.0;
};

// Never null. Bodies may share a mesh.
struct Polyhedron {
    std::shared_ptr<const PolyhedronMesh> mesh;
};

}  // namespace pushfactor::engine::collision
