// Where pictures are taken: the offscreen context, renderers of the sizes that are wanted, and the letters.
#pragma once

#include "demos/pictures/lettering.h"
#include "demos/pictures/stage_times.h"
#include "renderer/renderer.h"

#include <memory>
#include <string>
#include <tuple>
#include <vector>

namespace pushfactor::demos::pictures {

struct Size {
    int width = 0, height = 0;  // pixels
};

class Studio {
  public:
    // `gl` is "osmesa", "egl", or empty for the first of them that this machine has. `times`, if not null, is told
    // of the stages of each picture. Throws renderer::RendererError when there is no such offscreen context.
    explicit Studio(const std::string& gl = {}, StageTimes* times = nullptr);

    // The mean of `samples` drawings. Throws renderer::RendererError for what cannot be drawn.
    renderer::Image draw(const renderer::Picture& picture, const Size& size, int samples);

    // Puts it into `image`, whose memory is used again. What a picture has in common with the last one of the same
    // `seat`, 0, 1, ..., is not drawn again; each seat costs the memory of some images.
    void draw(const renderer::Picture& picture, const Size& size, int samples, renderer::Image& image,
              std::size_t seat = 0);

    // What has been done since the last picture is a stage of this name.
    void end(const std::string& stage) const {
        if (times_) times_->end_drawing(stage);
    }

    const Lettering& lettering() const { return lettering_; }

  private:
    struct Seat {
        std::tuple<int, int, int> made_for{};  // width, height, samples
        std::unique_ptr<renderer::Renderer> renderer;
    };

    StageTimes* times_;
    std::unique_ptr<renderer::OffscreenContext> context_;
    std::vector<Seat> seats_;
    Lettering lettering_;
};

// How long drawing takes, by the mean of some frames, when there is next to nothing to be seen.
StageTime time_of_empty_frame(const Size& size, const std::string& gl);

}  // namespace pushfactor::demos::pictures
