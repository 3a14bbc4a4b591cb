#pragma once

#include "renderer/gl/gl.h"
#include "renderer/meshes/convex_shape.h"
#include "renderer/meshes/instanced_mesh.h"

#include <map>
#include <memory>
#include <span>
#include <vector>

namespace pushfactor::renderer {

// Polyhedra with a mesh for each distinct shape, uploaded when it is first drawn.
class PolyhedronMeshes {
  public:
    explicit PolyhedronMeshes(const Gl& gl) : gl_(gl) {}

    // `shapes`: of all polyhedra of the picture, by Instance::number.
    void set_instances(std::span<const Instance> polyhedra,
                       std::span<const std::shared_ptr<const ConvexShape>> shapes);

    // Draws all polyhedra with the program in use.
    void draw() const;

  private:
    struct Before {
        bool operator()(const ConvexShape& a, const ConvexShape& b) const { return before(a, b); }
    };
    struct Drawn {
        Drawn(const Gl& gl, const Mesh& of) : mesh(gl, of) {}
        InstancedMesh mesh;
        std::vector<Instance> instances{};
    };

    const Gl& gl_;
    std::map<ConvexShape, Drawn, Before> meshes_;
    std::vector<Drawn*> drawn_;  // those with instances, in the order of the nearest of each
};

}  // namespace pushfactor::renderer
