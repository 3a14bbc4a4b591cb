#pragma once

#include "renderer/gl.h"
#include "renderer/gl_object.h"
#include "renderer/image.h"

#include <cstdint>
#include <vector>

namespace pushfactor::renderer {

// What a frame is drawn into: depth and colour (linear light in, sRGB stored), up to four samples a pixel.
class RenderTarget {
  public:
    // Throws RendererError when GL refuses the size (pixels).
    RenderTarget(const Gl& gl, int width, int height);

    // Directs drawing to all of this target.
    void bind() const;

    // The finished frame: the mean of each pixel's samples.
    Image read();

  private:
    const Gl& gl_;
    int width_;
    int height_;
    GlObject colour_;
    GlObject depth_;
    GlObject samples_;  // the framebuffer drawn into
    GlObject resolved_colour_;
    GlObject resolved_;  // the framebuffer read from
    std::vector<std::uint8_t> rgba_;
};

}  // namespace pushfactor::renderer
