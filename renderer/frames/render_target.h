#pragma once

#include "renderer/gl/gl.h"
#include "renderer/gl/gl_object.h"
#include "renderer/images/tiles.h"

#include <cstdint>
#include <span>

namespace pushfactor::renderer {

// What a frame is drawn into: linear light in, sRGB stored, with depth. The fourth channel tells surfaces whose
// edges are to be smoothed (not 0) from all that is smooth as it is drawn.
class RenderTarget {
  public:
    // Throws RendererError when GL refuses the size (pixels).
    RenderTarget(const Gl& gl, int width, int height);

    // Directs drawing here.
    void bind() const;

    // Copies the colours of these areas from another target of the same size. This one must be bound.
    void copy_colour(const RenderTarget& from, std::span<const PixelArea> areas) const;

    // Copies these areas into `rgba`, which holds the whole frame: rows from bottom to top, four bytes a pixel.
    void read(std::span<const PixelArea> areas, std::span<std::uint8_t> rgba) const;

  private:
    const Gl& gl_;
    int width_;
    int height_;
    GlObject colour_;
    GlObject depth_;
    GlObject framebuffer_;
};

}  // namespace pushfactor::renderer
