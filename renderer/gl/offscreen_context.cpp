#include "renderer/gl/offscreen_context.h"

#include "renderer/base/renderer_error.h"
#include "renderer/gl/egl_context.h"
#include "renderer/gl/gl.h"
#include "renderer/gl/osmesa_context.h"

namespace pushfactor::renderer {

std::unique_ptr<OffscreenContext> open_offscreen_context(std::optional<ContextKind> kind) {
    if (kind == ContextKind::osmesa) return open_osmesa_context();
    if (kind == ContextKind::egl) return open_egl_context();
    std::string without_osmesa;
    try {
        return open_osmesa_context();
    } catch (const RendererError& error) {
        without_osmesa = error.what();
    }
    try {
        return open_egl_context();
    } catch (const RendererError& error) {
        throw RendererError(without_osmesa + "; or for EGL: " + error.what());
    }
}

std::string gl_version_of(OffscreenContext& context) {
    const Gl gl = load_gl(context);
    const auto text = [&gl](GLenum name) -> std::string {
        const GLubyte* const found = gl.GetString(name);
        return found != nullptr ? reinterpret_cast<const char*>(found) : "unknown";
    };
    return text(GL_VERSION) + ", " + text(GL_RENDERER);
}

}  // namespace pushfactor::renderer
