#pragma once

#include "renderer/gl/gl.h"
#include "renderer/gl/gl_object.h"
#include "renderer/meshes/meshes.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <span>

namespace pushfactor::renderer {

// Vertex shader data of one body. World frame, m.
struct Instance {
    glm::vec3 position;
    float bevel;            // m, at most the smallest half extent; see Vertex
    glm::vec4 orientation;  // unit quaternion x, y, z, w, body to world
    glm::vec3 half_extents;
    glm::vec3 colour;  // linear light, 0..1
    float number;      // index among those of its kind in the picture
};

// A mesh on the GPU and its instances in a frame.
class InstancedMesh {
  public:
    InstancedMesh(const Gl& gl, const Mesh& mesh);

    void set_instances(std::span<const Instance> instances);

    // Draws all instances with the program in use.
    void draw() const;

  private:
    void begin_with(GLsizei instance) const;

    const Gl& gl_;
    GlObject attributes_;
    GlObject vertices_;
    GlObject indices_;
    GlObject instances_;
    GLsizei index_count_;
    GLsizei instance_count_ = 0;
};

}  // namespace pushfactor::renderer
