#include "renderer/gl/osmesa_context.h"

#include "renderer/base/renderer_error.h"
#include "renderer/base/shared_library.h"
#include "renderer/gl/gl_types.h"

#include <array>
#include <cstdint>

namespace pushfactor::renderer {
namespace {

// As in GL/osmesa.h of Mesa 22.3 (https://gitlab.freedesktop.org/mesa/mesa); Mesa 25.1 and later have no OSMesa.
using OSMesaContext = struct osmesa_context*;
constexpr int OSMESA_FORMAT = 0x22;
constexpr int OSMESA_PROFILE = 0x33;
constexpr int OSMESA_CORE_PROFILE = 0x34;
constexpr int OSMESA_CONTEXT_MAJOR_VERSION = 0x36;
constexpr int OSMESA_CONTEXT_MINOR_VERSION = 0x37;
constexpr int OSMESA_RGBA = 0x1908;

// OSMesa functions, loaded at run time.
struct OsmesaLibrary {
    std::string path;
    OSMesaContext (*create_context)(const int* attributes, OSMesaContext shared) = nullptr;
    void (*destroy_context)(OSMesaContext context) = nullptr;
    GLboolean (*make_current)(OSMesaContext context, void* buffer, GLenum type, GLsizei width,
                              GLsizei height) = nullptr;
    OSMesaContext (*current_context)() = nullptr;
    void (*(*function)(const char* name))() = nullptr;
};

OsmesaLibrary load_osmesa(const std::vector<std::string>& names) {
    const SharedLibrary library(names, "OSMesa", "install the package libosmesa6 (Mesa 25.0 or earlier)");
    OsmesaLibrary osmesa;
    osmesa.path = library.path();
    library.find("OSMesaCreateContextAttribs", osmesa.create_context);
    library.find("OSMesaDestroyContext", osmesa.destroy_context);
    library.find("OSMesaMakeCurrent", osmesa.make_current);
    library.find("OSMesaGetCurrentContext", osmesa.current_context);
    library.find("OSMesaGetProcAddress", osmesa.function);
    return osmesa;
}

OSMesaContext create_core_context(const OsmesaLibrary& osmesa) {
    constexpr std::array<std::array<int, 2>, 2> versions = {{{4, 5}, {3, 3}}};
    for (const auto& [major, minor] : versions) {
        const int attributes[][2] = {{OSMESA_PROFILE, OSMESA_CORE_PROFILE},
                                     {OSMESA_FORMAT, OSMESA_RGBA},
                                     {OSMESA_CONTEXT_MAJOR_VERSION, major},
                                     {OSMESA_CONTEXT_MINOR_VERSION, minor},
                                     {0, 0}};
        const OSMesaContext context = osmesa.create_context(attributes[0], nullptr);
        if (context != nullptr) return context;
    }
    throw RendererError("this OSMesa has no OpenGL 3.3 core context");
}

class OsmesaContext final : public OffscreenContext {
  public:
    explicit OsmesaContext(const OsmesaLibrary& osmesa) : osmesa_(osmesa), context_(create_core_context(osmesa)) {}

    ~OsmesaContext() override {
        // Mesa writes into the buffer when another context becomes current: unbind before it is freed.
        if (osmesa_.current_context() == context_) osmesa_.make_current(nullptr, nullptr, 0, 0, 0);
        osmesa_.destroy_context(context_);
    }

    void make_current() override {
        if (!osmesa_.make_current(context_, buffer_.data(), GL_UNSIGNED_BYTE, side, side)) {
            throw RendererError("OSMesa cannot make its context current");
        }
    }

    void* function(const char* name) override { return reinterpret_cast<void*>(osmesa_.function(name)); }

    std::string description() const override { return "OSMesa"; }
    std::string library() const override { return osmesa_.path; }

  private:
    static constexpr int side = 16;  // pixels

    OsmesaLibrary osmesa_;
    // Default framebuffer, required by OSMesa; lives as long as the context.
    std::array<std::uint8_t, std::size_t{4} * side * side> buffer_{};
    OSMesaContext context_;
};

}  // namespace

std::unique_ptr<OffscreenContext> open_osmesa_context(const std::vector<std::string>& libraries) {
    auto context = std::make_unique<OsmesaContext>(load_osmesa(libraries));
    context->make_current();
    return context;
}

}  // namespace pushfactor::renderer
