#include "renderer/frames/frame_checks.h"

#include "renderer/base/renderer_error.h"

#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>

namespace pushfactor::renderer {
namespace {

std::string hexadecimal(GLenum code) {
    std::ostringstream text;
    text << "code 0x" << std::hex << code;
    return text.str();
}

std::string error_name(GLenum error) {
    switch (error) {
        case GL_INVALID_ENUM:
            return "invalid enum";
        case GL_INVALID_VALUE:
            return "invalid value";
        case GL_INVALID_OPERATION:
            return "invalid operation";
        case GL_INVALID_FRAMEBUFFER_OPERATION:
            return "invalid framebuffer operation";
        case GL_OUT_OF_MEMORY:
            return "out of memory";
        case GL_CONTEXT_LOST:
            return "context lost";
        default:
            return hexadecimal(error);
    }
}

std::string status_name(GLenum status) {
    switch (status) {
        case GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT:
            return "incomplete attachment";
        case GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT:
            return "missing attachment";
        case GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE:
            return "unequal numbers of samples";
        case GL_FRAMEBUFFER_UNSUPPORTED:
            return "unsupported formats";
        default:
            return hexadecimal(status);
    }
}

}  // namespace

void check_gl_errors(const Gl& gl) {
    // A lost context may report an error on every call.
    constexpr int most = 8;
    std::string names;
    for (int i = 0; i < most; ++i) {
        const GLenum error = gl.GetError();
        if (error == GL_NO_ERROR) break;
        const std::string name = error_name(error);
        if (names.find(name) == std::string::npos) names += (names.empty() ? "" : ", ") + name;
    }
    if (!names.empty()) throw RendererError("OpenGL could not draw the picture: " + names);
}

void check_framebuffer(const Gl& gl, const char* purpose) {
    const GLenum status = gl.CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER);
    if (status == GL_FRAMEBUFFER_COMPLETE) return;
    throw RendererError(std::string("OpenGL cannot draw into ") + purpose + ": " + status_name(status));
}

bool shows_only(const glm::vec3& background, const Image& image) {
    const glm::vec3 bytes = 255.0f * background;
    const std::size_t count = image.rgb.size();
    // Starts in the middle, which is most likely to show something.
    const std::size_t first = count / 6 * 3;
    for (std::size_t n = 0; n < count; ++n) {
        const std::size_t i = first + n < count ? first + n : first + n - count;
        // GL may round the background colour up or down.
        if (std::abs(static_cast<float>(image.rgb[i]) - bytes[static_cast<int>(i % 3)]) > 1.0f) return false;
    }
    return true;
}

}  // namespace pushfactor::renderer
