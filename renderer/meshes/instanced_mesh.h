#pragma once

#include "renderer/gl/gl.h"
#include "renderer/gl/gl_object.h"
#include "renderer/meshes/meshes.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <span>

namespace pushfactor::renderer {

// One body as the vertex shaders see it. World frame, m.
struct Instance {
    glm::vec3 position;
    float bevel;            // m, at most the smallest half extent; see Vertex
    glm::vec4 orientation;  // unit quaternion x, y, z, w, body to world
    glm::vec3 half_extents;
    glm::vec3 colour;  // linear light, 0..1
    float number;      // in the picture's list of its kind, from 0
};

// A mesh on the GPU and the instances of it that a frame shows.
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
