#include "demos/pictures/graphics_check.h"

#include "demos/pictures/offscreen_renderer.h"
#include "demos/pictures/to_glm.h"
#include "demos/platform/assets.h"
#include "demos/text/text_hash.h"
#include "renderer/base/renderer_error.h"

namespace pushfactor::demos::pictures {

namespace {

constexpr Size size{320, 180};

// A ball beside a stack of three cubes, in the colours of the palette.
renderer::Picture test_picture() {
    renderer::Picture picture;
    picture.camera = {.eye = {3.0f, 2.6f, 7.0f}, .target = {0.4f, 1.2f, 0.0f}};
    picture.ground = renderer::Ground{};
    for (std::size_t i = 0; i < 3; ++i) {
        const float height = 0.5f + static_cast<float>(i);
        picture.bodies.push_back({.position = {0.0f, height, 0.0f}, .colour = to_glm(palette[i])});
    }
    picture.bodies.push_back(
        {.position = {1.6f, 0.5f, 0.5f}, .shape = renderer::Sphere{}, .colour = to_glm(palette[3])});
    return picture;
}

}  // namespace

Graphics check_graphics(renderer::ContextKind kind) {
    Graphics graphics;
    try {
        const auto context = renderer::open_offscreen_context(kind);
        graphics.found = context->library() + ": " + renderer::gl_version_of(*context);
        renderer::Renderer renderer(*context, size.width, size.height, asset_folder("shaders"));
        renderer::Image picture = renderer.render(test_picture());
        const renderer::Rectangle whole{0, 0, size.width, size.height};
        Lettering().caption(picture, whole, "pushfactor doctor", letter_size(size.height));
        graphics.picture = std::move(picture);
    } catch (const renderer::RendererError& error) {
        graphics.found += (graphics.found.empty() ? "" : "; ") + std::string(error.what());
    }
    return graphics;
}

std::uint64_t hash_of(const renderer::Image& image) {
    return fnv_hash({reinterpret_cast<const char*>(image.rgb.data()), image.rgb.size()});
}

}  // namespace pushfactor::demos::pictures
