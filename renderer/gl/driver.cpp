#include "renderer/gl/driver.h"

#include "renderer/gl/gl.h"

namespace pushfactor::renderer {

std::string driver_of(OffscreenContext& context) {
    const Gl gl = load_gl(context);
    const auto text = [&](GLenum name) { return std::string(reinterpret_cast<const char*>(gl.GetString(name))); };
    return context.description() + ", " + text(GL_VERSION) + ", " + text(GL_RENDERER);
}

}  // namespace pushfactor::renderer
