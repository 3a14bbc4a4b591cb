#pragma once

#include "renderer/frame_plan.h"
#include "renderer/gl.h"
#include "renderer/gl_object.h"
#include "renderer/image.h"

#include <cstdint>
#include <span>
#include <vector>

namespace pushfactor::renderer {

// What a frame is drawn into (linear light in, sRGB stored): an image without depth, and samples with depth, up to
// four a pixel, for those parts of it that need them.
class RenderTarget {
  public:
    // Throws RendererError when GL refuses the size (pixels).
    RenderTarget(const Gl& gl, int width, int height);

    // Directs drawing to the image.
    void bind_image() const;

    // Directs drawing to the samples.
    void bind_samples() const;

    // Puts the mean of each pixel's samples into these parts of the image.
    void resolve(std::span<const Rectangle> parts) const;

    // The finished frame.
    Image read();

  private:
    const Gl& gl_;
    int width_;
    int height_;
    GlObject colour_;
    GlObject depth_;
    GlObject samples_;  // the framebuffer with several samples a pixel
    GlObject image_colour_;
    GlObject image_;  // the framebuffer read from, and drawn into where one sample is enough
    std::vector<std::uint8_t> rgba_;
};

}  // namespace pushfactor::renderer
