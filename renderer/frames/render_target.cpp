#include "renderer/frames/render_target.h"

#include "renderer/frames/frame_checks.h"

#include <cassert>
#include <cstddef>

namespace pushfactor::renderer {
namespace {

// Attaches a renderbuffer to the bound framebuffer.
void attach(const Gl& gl, GLenum attachment, const GlObject& image, GLenum format, int width, int height) {
    gl.BindRenderbuffer(GL_RENDERBUFFER, image.name());
    gl.RenderbufferStorage(GL_RENDERBUFFER, format, width, height);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, image.name());
}

}  // namespace

RenderTarget::RenderTarget(const Gl& gl, int width, int height, Stored stored)
    : gl_(gl),
      width_(width),
      height_(height),
      colour_(gl.GenRenderbuffers, gl.DeleteRenderbuffers),
      depth_(gl.GenRenderbuffers, gl.DeleteRenderbuffers),
      framebuffer_(gl.GenFramebuffers, gl.DeleteFramebuffers) {
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    attach(gl, GL_COLOR_ATTACHMENT0, colour_, stored == Stored::bytes ? GL_SRGB8_ALPHA8 : GL_RGBA32F, width,
           height);
    attach(gl, GL_DEPTH_ATTACHMENT, depth_, GL_DEPTH_COMPONENT24, width, height);
    check_framebuffer(gl, "an image of this size");
}

void RenderTarget::bind() const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    gl_.Viewport(0, 0, width_, height_);
}

void RenderTarget::copy_colour(const RenderTarget& from, std::span<const PixelArea> areas) const {
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, from.framebuffer_.name());
    for (const auto& [x, y, width, height] : areas) {
        gl_.BlitFramebuffer(x, y, x + width, y + height, x, y, x + width, y + height, GL_COLOR_BUFFER_BIT,
                            GL_NEAREST);
    }
}

void RenderTarget::read(std::span<const PixelArea> areas, std::span<std::uint8_t> rgba) const {
    assert(rgba.size() == 4 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
    gl_.PixelStorei(GL_PACK_ROW_LENGTH, width_);
    for (const auto& [x, y, width, height] : areas) {
        const std::size_t first =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
        gl_.ReadPixels(x, y, width, height, GL_RGBA, GL_UNSIGNED_BYTE, &rgba[4 * first]);
    }
}

void RenderTarget::read(const PixelArea& area, std::span<float> rgba) const {
    assert(rgba.size() == 4 * static_cast<std::size_t>(area.width) * static_cast<std::size_t>(area.height));
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
    gl_.PixelStorei(GL_PACK_ROW_LENGTH, area.width);
    gl_.ReadPixels(area.x, area.y, area.width, area.height, GL_RGBA, GL_FLOAT, rgba.data());
}

}  // namespace pushfactor::renderer
