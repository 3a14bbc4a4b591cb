#pragma once

#include "renderer/gl/gl.h"
#include "renderer/gl/gl_object.h"
#include "renderer/picture/panels.h"

#include <span>

namespace pushfactor::renderer {

// The triangles of a frame's panels on the GPU.
class PanelMesh {
  public:
    explicit PanelMesh(const Gl& gl);

    void set_triangles(std::span<const PanelVertex> vertices);

    // Draws all triangles in their order with the program in use.
    void draw() const;

  private:
    const Gl& gl_;
    GlObject attributes_;
    GlObject vertices_;
    GLsizei vertex_count_ = 0;
};

}  // namespace pushfactor::renderer
