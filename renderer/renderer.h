#pragma once

#include "renderer/image.h"
#include "renderer/offscreen_context.h"
#include "renderer/picture.h"

#include <filesystem>
#include <memory>

namespace pushfactor::renderer {

// Draws pictures of one size. The same picture always gives the same bytes, whatever was drawn before.
class Renderer {
  public:
    static constexpr int max_side = 4096;  // pixels

    // `context` must outlive the renderer. Width and height are in pixels, each 1..max_side.
    // `shader_directory` holds the project's shaders. Throws RendererError for other sizes, and when a
    // shader is missing or refused.
    Renderer(OffscreenContext& context, int width, int height, const std::filesystem::path& shader_directory);
    ~Renderer();

    // Throws RendererError for a picture that check() refuses.
    Image render(const Picture& picture);

  private:
    class Pipeline;

    OffscreenContext& context_;
    std::unique_ptr<Pipeline> pipeline_;
};

}  // namespace pushfactor::renderer
