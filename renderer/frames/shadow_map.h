#pragma once

#include "renderer/gl/gl.h"
#include "renderer/gl/gl_object.h"

namespace pushfactor::renderer {

// Depth image as seen from a light. Lookups compare and interpolate; outside of the image everything is lit.
class ShadowMap {
  public:
    static constexpr int max_side = 2048;  // texels

    // Lookups use this texture unit, 0, 1, ...
    ShadowMap(const Gl& gl, int unit);

    // Binds a cleared map of this size in texels, each side 1..max_side, for drawing. Throws RendererError if GL
    // refuses it.
    void begin(int width, int height);

    // Binds the map to its texture unit.
    void bind_texture() const;

  private:
    const Gl& gl_;
    GLenum unit_;
    GlObject texture_;
    GlObject framebuffer_;
    int width_ = 0;   // texels
    int height_ = 0;  // texels
};

}  // namespace pushfactor::renderer
