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

// Parameters of the backdrop, which is behind all bodies and shadows: background colour, and ground in full light.
struct BackdropView {
    glm::mat4 world_to_clip;
    glm::vec3 towards_sun;  // unit length
    Camera camera;
    Background background;
    std::optional<Ground> ground;

    bool operator==(const BackdropView&) const = default;
};

// Cached image of the backdrop, valid while camera, ground and sun are unchanged.
class Backdrop {
  public:
    // Size in pixels. Throws RendererError if GL refuses it.
    Backdrop(const Gl& gl, int width, int height, Stored stored);

    // Announces the backdrop of this frame. True if it is that of the last call: only a backdrop used twice is
    // worth caching.
    bool is_worth_keeping(const BackdropView& view);

    // Whether the image holds it; bind() directs drawing to the image, which then counts as drawn.
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
