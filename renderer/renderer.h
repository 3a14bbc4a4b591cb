#pragma once

#include "renderer/frames/stages.h"
#include "renderer/gl/offscreen_context.h"
#include "renderer/images/image.h"
#include "renderer/picture/picture.h"

#include <filesystem>
#include <memory>

namespace pushfactor::renderer {

// Draws pictures of one size. The same picture always gives the same bytes, whatever was drawn before; but what it
// has in common with the one before is kept and not drawn again.
class Renderer {
  public:
    static constexpr int max_side = 4096;  // pixels
    static constexpr int max_samples = 256;

    // `context` must outlive the renderer. Width and height are in pixels, each 1..max_side.
    // `shader_directory` holds the project's shaders. `samples`, 1..max_samples, is the number of times that a
    // picture is drawn, each time moved by a part of a pixel and lit from another point of the sun's disc; the
    // image is their mean, taken in linear light. One is for videos; more take as much longer, no more memory,
    // and give stills finer edges and shadows that are the softer the farther they fall.
    // `stages`, if not null, is told of the stages of each frame, which are then done one after the other: that
    // takes a little longer. Throws RendererError for other numbers, when a shader is missing or refused, and when
    // GL fails.
    Renderer(OffscreenContext& context, int width, int height, const std::filesystem::path& shader_directory,
             int samples = 1, Stages* stages = nullptr);
    ~Renderer();

    // Never a blank image. Throws RendererError for a picture that check() refuses or of which the camera sees
    // nothing, and when GL fails; the message says why.
    Image render(const Picture& picture);

    // Puts it into `image`; what that held before is used for its memory only.
    void render(const Picture& picture, Image& image);

  private:
    class Pipeline;

    OffscreenContext& context_;
    std::unique_ptr<Pipeline> pipeline_;
};

}  // namespace pushfactor::renderer
