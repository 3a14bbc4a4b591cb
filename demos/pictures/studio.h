// Where pictures are taken: the offscreen context, renderers of the sizes that are wanted, and the letters.
#pragma once

#include "demos/pictures/lettering.h"
#include "renderer/renderer.h"

#include <memory>
#include <tuple>

namespace pushfactor::demos::pictures {

struct Size {
    int width = 0, height = 0;  // pixels
};

class Studio {
  public:
    // Throws renderer::RendererError when this machine has no offscreen context.
    Studio() : context_(renderer::open_offscreen_context()) {}

    // The mean of `samples` drawings. Throws renderer::RendererError for what cannot be drawn.
    renderer::Image draw(const renderer::Picture& picture, const Size& size, int samples);

    const Lettering& lettering() const { return lettering_; }

  private:
    std::unique_ptr<renderer::OffscreenContext> context_;
    std::tuple<int, int, int> made_for_{};  // width, height, samples
    std::unique_ptr<renderer::Renderer> renderer_;
    Lettering lettering_;
};

}  // namespace pushfactor::demos::pictures
