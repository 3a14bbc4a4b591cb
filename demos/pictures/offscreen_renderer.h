// The offscreen context with its renderers and the lettering, and whether there is one.
#pragma once

#include "demos/pictures/film/stage_times.h"
#include "demos/pictures/lettering.h"
#include "renderer/gl/offscreen_context.h"
#include "renderer/renderer.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <tuple>
#include <vector>

namespace pushfactor::demos::pictures {

struct Size {
    int width = 0, height = 0;  // pixels
};

class OffscreenRenderer {
  public:
    // `gl` is "osmesa", "egl", or empty for the first available. `times`, if not null, receives the stages of each
    // picture. Throws renderer::RendererError if there is no such offscreen context.
    explicit OffscreenRenderer(const std::string& gl = {}, StageTimes* times = nullptr);

    // Averages `samples` renderings. Throws renderer::RendererError for what cannot be drawn.
    renderer::Image draw(const renderer::Picture& picture, const Size& size, int samples);

    // The same into `image`, whose memory is reused. Content equal to that of the last picture of the same `slot`,
    // 0, 1, ..., is not drawn again; each slot takes the memory of some images.
    // With several pictures the samples are spread over them, in their order, for motion blur.
    void draw(std::span<const renderer::Picture> pictures, const Size& size, int samples, renderer::Image& image,
              std::size_t slot = 0);

    // Adds the time since the last picture to this stage.
    void end(const std::string& stage) const {
        if (times_) times_->end_drawing(stage);
    }

    const Lettering& lettering() const { return lettering_; }

    // Pictures in which nothing is in view of the camera.
    long blank() const { return blank_; }

    // What draws, with back end and versions. Equal texts stand for equal bytes of equal pictures.
    std::string driver() const { return context_->description() + ", " + renderer::gl_version_of(*context_); }

  private:
    struct CachedRenderer {
        std::tuple<int, int, int> made_for{};  // width, height, samples
        std::unique_ptr<renderer::Renderer> renderer;
    };

    StageTimes* times_;
    std::unique_ptr<renderer::OffscreenContext> context_;
    std::vector<CachedRenderer> renderers_;
    Lettering lettering_;
    long blank_ = 0;
};

// Mean time per frame of a nearly empty picture.
StageTime time_of_empty_frame(const Size& size, const std::string& gl);

// A back end, tried.
struct Graphics {
    std::string found;        // library, version and renderer, or what is missing and what to install
    renderer::Image picture;  // the test picture; empty if it could not be drawn
};

// Opens a context of this kind and draws a small test picture with text. Errors are reported in the result.
Graphics check_graphics(renderer::ContextKind kind);

// FNV-1a of an image's bytes.
std::uint64_t hash_of(const renderer::Image& image);

}  // namespace pushfactor::demos::pictures
