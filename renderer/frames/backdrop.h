#pragma once

#include "renderer/frames/render_target.h"
#include "renderer/gl/gl.h"
#include "renderer/gl/gl_object.h"
#include "renderer/images/tiles.h"
#include "renderer/picture/picture.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <optional>

namespace pushfactor::renderer {

// What is behind all bodies and their shadows: the background, and the ground in full light.
struct BackdropView {
    glm::mat4 world_to_clip;
    glm::vec3 towards_sun;  // unit length
    Camera camera;
    std::optional<Ground> ground;

    bool operator==(const BackdropView&) const = default;
};

// An image of it, kept as long as camera, ground and sun stay as they are.
class Backdrop {
  public:
    // Pixels. Throws RendererError when GL refuses the size.
    Backdrop(const Gl& gl, int width, int height);

    // Says which backdrop is wanted. True when it is the one of the last call: only what is wanted a second time is
    // worth an image of its own.
    bool is_worth_keeping(const BackdropView& view);

    // Whether it is in the image; bind() directs drawing there, and then it is.
    bool is_drawn() const { return drawn_; }
    void bind();

    const RenderTarget& image() const { return image_; }
    const PixelArea& whole() const { return whole_; }

  private:
    RenderTarget image_;
    PixelArea whole_;
    std::optional<BackdropView> view_;
    bool drawn_ = false;
};

}  // namespace pushfactor::renderer
