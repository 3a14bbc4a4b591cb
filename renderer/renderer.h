#pragma once

#include "renderer/frames/stages.h"
#include "renderer/gl/offscreen_context.h"
#include "renderer/images/image.h"
#include "renderer/picture/picture.h"

#include <filesystem>
#include <memory>
#include <span>

namespace pushfactor::renderer {

// Renders pictures of one size. The same picture always gives the same bytes, whatever was drawn before; unchanged
// parts of the previous frame are reused.
class Renderer {
  public:
    static constexpr int max_side = 4096;  // pixels
    static constexpr int max_samples = 256;
    static constexpr int least_sky_samples = 16;  // fewer would show as single shadows

    // `context` must outlive the renderer. Width and height in pixels, each 1..max_side. `shader_directory` holds
    // the project's shaders. `samples`, 1..max_samples: averages that many renderings in linear light, each shifted
    // by a part of a pixel and lit from another point of the sun's disc, for smoother edges and soft shadows; from
    // least_sky_samples on each looks for what hides another part of the sky. 1 is for videos; time is proportional
    // to it, memory is not. `stages`, if not null, is notified of the stages of each frame, which then run one
    // after the other, which takes slightly longer. Throws RendererError for other values, if a shader is missing
    // or does not compile, and if GL fails.
    Renderer(OffscreenContext& context, int width, int height, const std::filesystem::path& shader_directory,
             int samples = 1, Stages* stages = nullptr);
    ~Renderer();

    // Throws RendererError for a picture that check() rejects, and if GL fails; the message says why.
    Image render(const Picture& picture);

    // Renders into `image`, whose old contents are used only for their memory. The samples are spread over several
    // pictures in their order, for motion blur; their marks are those of the last.
    void render(std::span<const Picture> pictures, Image& image);

    // How many of the pictures so far show only the background, because nothing is in view of their camera.
    long blank() const { return blank_; }

  private:
    class Pipeline;

    OffscreenContext& context_;
    std::unique_ptr<Pipeline> pipeline_;
    long blank_ = 0;
};

}  // namespace pushfactor::renderer
