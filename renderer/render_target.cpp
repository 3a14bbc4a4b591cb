#include "renderer/render_target.h"

#include "renderer/frame_checks.h"

#include <algorithm>
#include <cstddef>

namespace pushfactor::renderer {
namespace {

// Gives the bound framebuffer an image of its own.
void attach(const Gl& gl, GLenum attachment, const GlObject& image, GLenum format, int samples, int width,
            int height) {
    gl.BindRenderbuffer(GL_RENDERBUFFER, image.name());
    gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, image.name());
}

}  // namespace

RenderTarget::RenderTarget(const Gl& gl, int width, int height)
    : gl_(gl),
      width_(width),
      height_(height),
      colour_(gl.GenRenderbuffers, gl.DeleteRenderbuffers),
      depth_(gl.GenRenderbuffers, gl.DeleteRenderbuffers),
      samples_(gl.GenFramebuffers, gl.DeleteFramebuffers),
      image_colour_(gl.GenRenderbuffers, gl.DeleteRenderbuffers),
      image_(gl.GenFramebuffers, gl.DeleteFramebuffers),
      rgba_(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
    GLint samples = 0;
    gl.GetIntegerv(GL_MAX_SAMPLES, &samples);
    samples = std::min(samples, 4);

    gl.BindFramebuffer(GL_FRAMEBUFFER, samples_.name());
    attach(gl, GL_COLOR_ATTACHMENT0, colour_, GL_SRGB8_ALPHA8, samples, width, height);
    attach(gl, GL_DEPTH_ATTACHMENT, depth_, GL_DEPTH_COMPONENT24, samples, width, height);
    check_framebuffer(gl, "samples of this size");

    gl.BindFramebuffer(GL_FRAMEBUFFER, image_.name());
    attach(gl, GL_COLOR_ATTACHMENT0, image_colour_, GL_SRGB8_ALPHA8, 0, width, height);
    check_framebuffer(gl, "an image of this size");
}

void RenderTarget::bind_image() const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, image_.name());
    gl_.Viewport(0, 0, width_, height_);
}

void RenderTarget::bind_samples() const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, samples_.name());
    gl_.Viewport(0, 0, width_, height_);
}

void RenderTarget::resolve(std::span<const Rectangle> parts) const {
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, samples_.name());
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, image_.name());
    for (const auto& [x, y, width, height] : parts) {
        gl_.BlitFramebuffer(x, y, x + width, y + height, x, y, x + width, y + height, GL_COLOR_BUFFER_BIT,
                            GL_NEAREST);
    }
}

Image RenderTarget::read() {
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, image_.name());
    gl_.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, rgba_.data());
    return image_from_bottom_up_rgba(width_, height_, rgba_);
}

}  // namespace pushfactor::renderer
