#pragma once

#include "renderer/images/tiles.h"
#include "renderer/picture/bodies.h"
#include "renderer/picture/picture.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace pushfactor::renderer {

// How one drawing of a frame sees the world.
struct FrameView {
    int width;   // pixels
    int height;  // pixels
    glm::mat4 world_to_clip;
    glm::vec3 towards_sun;  // unit length
    float texel;            // side of a texel of the shadow map, m
    float pixel;            // side of a pixel at a distance of 1 m from the eye, m
};

// The tiles in which bodies and panels may be seen.
Tiles occupied_tiles(const FrameView& view, std::span<const Instance> bodies, std::span<const Panel> panels);

// The tiles in which shadows of the bodies may fall on the ground; none when the sun does not light it.
Tiles shadowed_tiles(const FrameView& view, std::span<const Instance> bodies, const Ground& ground);

// The tiles in which bodies may darken the ground by their nearness.
Tiles touched_tiles(const FrameView& view, std::span<const Instance> bodies, const Ground& ground);

// The tiles in which shadows of the bodies may fall on anything down to `distance` m from them.
Tiles swept_tiles(const FrameView& view, std::span<const Instance> bodies, float distance);

// The areas of a frame that are drawn, by what the ground in them needs: lookups of the shadow are most of its
// time. Each pixel of the tiles is in one of them.
struct FramePlan {
    std::vector<PixelArea> lit;       // no shadow falls on the ground
    std::vector<PixelArea> shadowed;  // one may
};
FramePlan plan_frame(const Tiles& drawn, const Tiles& shadowed);

}  // namespace pushfactor::renderer
