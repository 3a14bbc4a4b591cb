#pragma once

#include "renderer/images/tiles.h"
#include "renderer/picture/bodies.h"
#include "renderer/picture/picture.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace pushfactor::renderer {

// Parameters of one rendering of a frame.
struct FrameView {
    int width;   // pixels
    int height;  // pixels
    glm::mat4 world_to_clip;
    glm::vec3 towards_sun;  // unit length
    float texel;            // side length of a texel of the shadow map, m
    float pixel;            // side length of a pixel at a distance of 1 m from the eye, m
};

// Tiles in which bodies and panels may be visible.
Tiles occupied_tiles(const FrameView& view, std::span<const Instance> bodies, std::span<const Panel> panels);

// Tiles in which shadows of the bodies may fall on the ground; none if the sun does not light it.
Tiles shadowed_tiles(const FrameView& view, std::span<const Instance> bodies, const Ground& ground);

// Tiles in which bodies may darken the ground by contact.
Tiles touched_tiles(const FrameView& view, std::span<const Instance> bodies, const Ground& ground);

// Tiles in which shadows of the bodies may fall on anything up to `distance` m below them along the light.
Tiles swept_tiles(const FrameView& view, std::span<const Instance> bodies, float distance);

// Areas of a frame to draw, by whether the ground needs shadow lookups, which take most of its time. Each pixel of
// the tiles is in exactly one area.
struct FramePlan {
    std::vector<PixelArea> lit;       // no shadow falls on the ground
    std::vector<PixelArea> shadowed;  // a shadow may
};
FramePlan plan_frame(const Tiles& drawn, const Tiles& shadowed);

}  // namespace pushfactor::renderer
