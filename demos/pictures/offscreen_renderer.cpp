#include "demos/pictures/offscreen_renderer.h"

#include "demos/base/platform/assets.h"
#include "demos/base/text/text_hash.h"
#include "demos/pictures/to_glm.h"
#include "renderer/base/renderer_error.h"

#include <optional>

namespace pushfactor::demos::pictures {

namespace {

std::optional<renderer::ContextKind> kind_of(const std::string& gl) {
    if (gl == "osmesa") return renderer::ContextKind::osmesa;
    if (gl == "egl") return renderer::ContextKind::egl;
    return std::nullopt;
}

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

OffscreenRenderer::OffscreenRenderer(const std::string& gl, StageTimes* times)
    : times_(times), context_(renderer::open_offscreen_context(kind_of(gl))) {
    if (times_) times_->end_drawing("set up");
}

renderer::Image OffscreenRenderer::draw(const renderer::Picture& picture, const Size& size, int samples) {
    renderer::Image image;
    draw(std::span(&picture, 1), size, samples, image);
    return image;
}

void OffscreenRenderer::draw(std::span<const renderer::Picture> pictures, const Size& size, int samples,
                             renderer::Image& image, std::size_t slot) {
    if (times_) times_->begin_drawing();
    if (renderers_.size() <= slot) renderers_.resize(slot + 1);
    auto& [made_for, renderer] = renderers_[slot];
    const std::tuple wanted{size.width, size.height, samples};
    if (!renderer || wanted != made_for) {
        renderer.reset();
        renderer = std::make_unique<renderer::Renderer>(*context_, size.width, size.height, asset_folder("shaders"),
                                                        samples, times_);
        made_for = wanted;
        end("set up");
    }
    const long before = renderer->blank();
    renderer->render(pictures, image);
    blank_ += renderer->blank() - before;
}

StageTime time_of_empty_frame(const Size& size, const std::string& gl) {
    constexpr int frames = 20;
    OffscreenRenderer offscreen(gl);
    renderer::Image image;
    StageTime start;
    for (int frame = 0; frame <= frames; ++frame) {
        if (frame == 1) start = process_time();  // the first one compiles shaders
        // A new camera per frame, so that nothing can be reused.
        renderer::Picture picture{.camera = {}, .bodies = {{.shape = renderer::Sphere{0.2f}}}};
        picture.camera.eye.x = 0.1f * static_cast<float>(frame);
        offscreen.draw(std::span(&picture, 1), size, 1, image);
    }
    const StageTime end = process_time();
    return {.wall = (end.wall - start.wall) / frames, .cpu = (end.cpu - start.cpu) / frames};
}

Graphics check_graphics(renderer::ContextKind kind) {
    constexpr Size size{320, 180};
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
