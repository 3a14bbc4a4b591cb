#include "renderer/gl/osmesa_context.h"

#include "renderer/base/renderer_error.h"
#include "renderer/base/shared_library.h"

#include <GL/osmesa.h>

#include <array>
#include <cstdint>

namespace pushfactor::renderer {
namespace {

// The part of OSMesa that is used, found at run time.
struct OsmesaLibrary {
    decltype(&OSMesaCreateContextAttribs) create_context = nullptr;
    decltype(&OSMesaDestroyContext) destroy_context = nullptr;
    decltype(&OSMesaMakeCurrent) make_current = nullptr;
    decltype(&OSMesaGetCurrentContext) current_context = nullptr;
    decltype(&OSMesaGetProcAddress) function = nullptr;
};

OsmesaLibrary load_osmesa(const std::vector<std::string>& names) {
    const SharedLibrary library(names, "OSMesa", "install the package libosmesa6");
    OsmesaLibrary osmesa;
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

  private:
    static constexpr int side = 16;  // pixels

    OsmesaLibrary osmesa_;
    // The default framebuffer that OSMesa insists on; it lives as long as the context.
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
