#pragma once

#include "renderer/gl/gl.h"
#include "renderer/meshes/instanced_mesh.h"
#include "renderer/picture/picture.h"

#include <array>
#include <span>

namespace pushfactor::renderer {

// Spheres drawn with as many triangles as their size in the picture asks for.
class SphereMeshes {
  public:
    explicit SphereMeshes(const Gl& gl);

    // `pixel` is the side of a pixel at a distance of 1 m from the eye, m.
    void set_instances(std::span<const Instance> spheres, const glm::vec3& eye, float pixel);

    // Draws all spheres with the program in use.
    void draw() const;

  private:
    std::array<InstancedMesh, 4> levels_;  // from coarse to fine
};

}  // namespace pushfactor::renderer
