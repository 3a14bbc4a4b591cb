#pragma once

#include "renderer/gl/gl.h"
#include "renderer/gl/gl_object.h"
#include "renderer/images/tiles.h"

#include <cstdint>
#include <span>

namespace pushfactor::renderer {

// How a framebuffer stores light: exposed, as sRGB bytes; or as floats, to be summed and exposed later.
enum class Stored { bytes, light };

// Framebuffer of a frame: linear light in, with depth. Alpha is 0 for pixels drawn with smooth edges, and not 0 for
// surfaces whose edges are to be smoothed.
class RenderTarget {
  public:
    // Size in pixels. Throws RendererError if GL refuses it.
    RenderTarget(const Gl& gl, int width, int height, Stored stored);

    // Binds it for drawing.
    void bind() const;

    // Copies the colours of these areas from another target of the same size. This one must be bound.
    void copy_colour(const RenderTarget& from, std::span<const PixelArea> areas) const;

    // Copies these areas into `rgba`, which holds the whole frame: rows from bottom to top, four bytes per pixel.
    void read(std::span<const PixelArea> areas, std::span<std::uint8_t> rgba) const;

    // Copies one area of stored light into `rgba`, which is as large as the area: rows from bottom to top, four
    // floats per pixel.
    void read(const PixelArea& area, std::span<float> rgba) const;

  private:
    const Gl& gl_;
    int width_;
    int height_;
    GlObject colour_;
    GlObject depth_;
    GlObject framebuffer_;
};

}  // namespace pushfactor::renderer
