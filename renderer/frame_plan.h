#pragma once

#include "renderer/bodies.h"
#include "renderer/picture.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

namespace pushfactor::renderer {

// A rectangle of the frame in pixels, from its lower left corner, as GL counts.
struct Rectangle {
    int x;
    int y;
    int width;
    int height;
};

// Which square tiles of a frame something is in, or might be.
class Tiles {
  public:
    static constexpr int side = 32;  // pixels

    // The frame's size, pixels; nothing is in it yet.
    Tiles(int width, int height);

    int columns() const { return columns_; }
    int rows() const { return rows_; }
    bool has(int column, int row) const { return marked_[index(column, row)]; }

    // Adds all tiles in which the camera sees a part of a ball, world frame, m.
    void add_ball(const glm::mat4& world_to_clip, const glm::vec3& centre, float radius);

    // Adds all tiles in which the camera sees a part of a convex polygon, and some around them.
    void add_polygon(const glm::mat4& world_to_clip, const std::vector<glm::vec3>& corners);

  private:
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column);
    }
    // In clip space divided by w: what is drawn has both coordinates in -1..1.
    void add(const glm::vec2& low, const glm::vec2& high);

    int width_;
    int height_;
    int columns_;
    int rows_;
    std::vector<bool> marked_;
};

// How the parts of a frame have to be drawn. Few of its pixels show the edge of a body or a shadow, and only
// there are several samples a pixel and lookups of the shadow worth their time, which is most of a frame's.
struct FramePlan {
    // The rectangles of one kind cover each of its pixels once.
    struct Part {
        std::vector<Rectangle> lit;       // where no shadow falls on the ground
        std::vector<Rectangle> shadowed;  // where one may
    };
    Part bare;   // nothing but ground and background
    Part edged;  // bodies and panels may be seen
};

// The plan of a frame of this size in pixels. `texel` is that of the shadow map, m; `towards_sun` has unit length.
FramePlan plan_frame(int width, int height, const glm::mat4& world_to_clip, const Bodies& bodies,
                     const Picture& picture, const glm::vec3& towards_sun, float texel);

}  // namespace pushfactor::renderer
