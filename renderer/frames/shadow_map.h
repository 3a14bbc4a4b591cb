#pragma once

#include "renderer/gl/gl.h"
#include "renderer/gl/gl_object.h"

namespace pushfactor::renderer {

// A depth image seen from the sun. Lookups compare and interpolate; outside of the image everything is lit.
class ShadowMap {
  public:
    static constexpr int max_side = 2048;  // texels

    explicit ShadowMap(const Gl& gl);

    // Directs drawing to a new, empty map of this size in texels, each side 1..max_side. Throws
    // RendererError when GL refuses it.
    void begin(int width, int height);

    // Makes the map the texture of unit 0.
    void bind_texture() const;

  private:
    const Gl& gl_;
    GlObject texture_;
    GlObject framebuffer_;
    int width_ = 0;   // texels
    int height_ = 0;  // texels
};

}  // namespace pushfactor::renderer
