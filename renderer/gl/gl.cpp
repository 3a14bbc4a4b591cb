#include "renderer/gl/gl.h"

#include "renderer/base/renderer_error.h"
#include "renderer/gl/offscreen_context.h"

#include <cstdio>
#include <string>

namespace pushfactor::renderer {
namespace {

template <typename Function>
void load(OffscreenContext& context, const char* name, Function& function) {
    function = reinterpret_cast<Function>(context.function(name));
    if (function == nullptr) throw RendererError(context.description() + " has no function " + name);
}

// Checked by version, because a loader may return addresses for unknown names, too.
void check_version(const Gl& gl, const OffscreenContext& context) {
    const auto* version = reinterpret_cast<const char*>(gl.GetString(GL_VERSION));
    const std::string text = version != nullptr ? version : "an unknown version";
    int major = 0;
    int minor = 0;
    const bool known = std::sscanf(text.c_str(), "%d.%d", &major, &minor) == 2;
    if (!known || major < 3 || (major == 3 && minor < 3)) {
        throw RendererError(context.description() + " offers OpenGL " + text + ", but 3.3 is needed");
    }
}

}  // namespace

Gl load_gl(OffscreenContext& context) {
    context.make_current();
    Gl gl;
#define PUSHFACTOR_GL_LOAD(name, type) load(context, "gl" #name, gl.name);
    PUSHFACTOR_GL_FUNCTIONS(PUSHFACTOR_GL_LOAD)
#undef PUSHFACTOR_GL_LOAD
    check_version(gl, context);
    return gl;
}

}  // namespace pushfactor::renderer
