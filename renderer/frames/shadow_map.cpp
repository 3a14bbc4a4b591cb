#include "renderer/frames/shadow_map.h"

#include "renderer/frames/frame_checks.h"

#include <array>

namespace pushfactor::renderer {

ShadowMap::ShadowMap(const Gl& gl, int unit)
    : gl_(gl),
      unit_(GL_TEXTURE0 + static_cast<GLenum>(unit)),
      texture_(gl.GenTextures, gl.DeleteTextures),
      framebuffer_(gl.GenFramebuffers, gl.DeleteFramebuffers) {
    constexpr std::array<float, 4> farthest = {1.0f, 1.0f, 1.0f, 1.0f};
    gl.BindTexture(GL_TEXTURE_2D, texture_.name());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    gl.TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, farthest.data());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);

    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture_.name(), 0);
    gl.DrawBuffer(GL_NONE);
    gl.ReadBuffer(GL_NONE);
}

void ShadowMap::begin(int width, int height) {
    if (width != width_ || height != height_) {
        bind_texture();
        gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, width, height, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                       nullptr);
        width_ = width;
        height_ = height;
    }
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    check_framebuffer(gl_, "a shadow map");
    gl_.Viewport(0, 0, width, height);
    gl_.Clear(GL_DEPTH_BUFFER_BIT);
}

void ShadowMap::bind_texture() const {
    gl_.ActiveTexture(unit_);
    gl_.BindTexture(GL_TEXTURE_2D, texture_.name());
}

}  // namespace pushfactor::renderer
