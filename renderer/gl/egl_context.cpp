#include "renderer/gl/egl_context.h"

#include "renderer/base/renderer_error.h"
#include "renderer/base/shared_library.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace pushfactor::renderer {
namespace {

const char* const packages = "install the packages libegl1, libegl-mesa0 and libgl1-mesa-dri";

// As in egl.h and eglext.h of https://github.com/KhronosGroup/EGL-Registry, which Debian packages together with X.
using EGLint = std::int32_t;
using EGLenum = unsigned int;
using EGLBoolean = unsigned int;
using EGLAttrib = std::intptr_t;
using EGLDisplay = void*;
using EGLConfig = void*;
using EGLContext = void*;
using EGLSurface = void*;
constexpr EGLBoolean EGL_TRUE = 1;
constexpr EGLint EGL_NONE = 0x3038;
constexpr EGLint EGL_EXTENSIONS = 0x3055;
constexpr EGLint EGL_CONTEXT_MAJOR_VERSION = 0x3098;
constexpr EGLint EGL_CONTEXT_MINOR_VERSION = 0x30FB;
constexpr EGLint EGL_CONTEXT_OPENGL_PROFILE_MASK = 0x30FD;
constexpr EGLint EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT = 1;
constexpr EGLenum EGL_OPENGL_API = 0x30A2;
constexpr EGLenum EGL_PLATFORM_SURFACELESS_MESA = 0x31DD;
constexpr std::nullptr_t EGL_DEFAULT_DISPLAY = nullptr;
constexpr std::nullptr_t EGL_NO_DISPLAY = nullptr;
constexpr std::nullptr_t EGL_NO_CONFIG_KHR = nullptr;
constexpr std::nullptr_t EGL_NO_CONTEXT = nullptr;
constexpr std::nullptr_t EGL_NO_SURFACE = nullptr;

// EGL functions, loaded at run time.
struct EglLibrary {
    std::string path;
    void (*(*function)(const char* name))() = nullptr;
    EGLDisplay (*platform_display)(EGLenum platform, void* native, const EGLAttrib* attributes) = nullptr;
    const char* (*query_string)(EGLDisplay display, EGLint name) = nullptr;
    EGLBoolean (*initialise)(EGLDisplay display, EGLint* major, EGLint* minor) = nullptr;
    EGLBoolean (*bind_api)(EGLenum api) = nullptr;
    EGLContext (*create_context)(EGLDisplay display, EGLConfig config, EGLContext shared,
                                 const EGLint* attributes) = nullptr;
    EGLBoolean (*destroy_context)(EGLDisplay display, EGLContext context) = nullptr;
    EGLBoolean (*make_current)(EGLDisplay display, EGLSurface draw, EGLSurface read, EGLContext context) = nullptr;
    EGLContext (*current_context)() = nullptr;
};

EglLibrary load_egl(const std::vector<std::string>& names) {
    const SharedLibrary library(names, "EGL", packages);
    EglLibrary egl;
    egl.path = library.path();
    library.find("eglGetProcAddress", egl.function);
    library.find("eglGetPlatformDisplay", egl.platform_display);
    library.find("eglQueryString", egl.query_string);
    library.find("eglInitialize", egl.initialise);
    library.find("eglBindAPI", egl.bind_api);
    library.find("eglCreateContext", egl.create_context);
    library.find("eglDestroyContext", egl.destroy_context);
    library.find("eglMakeCurrent", egl.make_current);
    library.find("eglGetCurrentContext", egl.current_context);
    return egl;
}

// One per process; stays open, because other contexts may use it.
EGLDisplay open_display(const EglLibrary& egl) {
    constexpr int keep_what_is_set = 0;
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", keep_what_is_set);
    const EGLDisplay display = egl.platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY || egl.initialise(display, nullptr, nullptr) != EGL_TRUE) {
        throw RendererError(std::string("this EGL cannot draw without a display: ") + packages);
    }
    const char* const extensions = egl.query_string(display, EGL_EXTENSIONS);
    for (const char* needed : {"EGL_KHR_surfaceless_context", "EGL_KHR_no_config_context"}) {
        if (extensions == nullptr || std::string_view(extensions).find(needed) == std::string_view::npos) {
            throw RendererError(std::string("this EGL has no ") + needed);
        }
    }
    return display;
}

// The API is bound per thread.
void bind_opengl(const EglLibrary& egl) {
    if (egl.bind_api(EGL_OPENGL_API) != EGL_TRUE) throw RendererError("this EGL has no OpenGL");
}

EGLContext create_core_context(const EglLibrary& egl, EGLDisplay display) {
    bind_opengl(egl);
    constexpr std::array<std::array<EGLint, 2>, 2> versions = {{{4, 5}, {3, 3}}};
    for (const auto& [major, minor] : versions) {
        const std::array<EGLint, 7> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                               major,
                                               EGL_CONTEXT_MINOR_VERSION,
                                               minor,
                                               EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                               EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                               EGL_NONE};
        const EGLContext context =
            egl.create_context(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
        if (context != EGL_NO_CONTEXT) return context;
    }
    throw RendererError("this EGL has no OpenGL 3.3 core context");
}

class EglContext final : public OffscreenContext {
  public:
    explicit EglContext(const EglLibrary& egl)
        : egl_(egl), display_(open_display(egl)), context_(create_core_context(egl, display_)) {}

    ~EglContext() override {
        if (egl_.current_context() == context_) {
            egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        }
        egl_.destroy_context(display_, context_);
    }

    void make_current() override {
        bind_opengl(egl_);
        if (egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_TRUE) {
            throw RendererError("EGL cannot make its context current");
        }
    }

    void* function(const char* name) override { return reinterpret_cast<void*>(egl_.function(name)); }

    std::string description() const override { return "EGL"; }
    std::string library() const override { return egl_.path; }

  private:
    EglLibrary egl_;
    EGLDisplay display_;
    EGLContext context_;
};

}  // namespace

std::unique_ptr<OffscreenContext> open_egl_context(const std::vector<std::string>& libraries) {
    auto context = std::make_unique<EglContext>(load_egl(libraries));
    context->make_current();
    return context;
}

}  // namespace pushfactor::renderer
