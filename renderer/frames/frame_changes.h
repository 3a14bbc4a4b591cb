#pragma once

#include "renderer/frames/frame_plan.h"
#include "renderer/picture/bodies.h"
#include "renderer/picture/picture.h"
#include "renderer/picture/views.h"

#include <optional>
#include <vector>

namespace pushfactor::renderer {

// All that decides what a frame looks like before marks are drawn over it.
struct FrameContents {
    Camera camera;
    std::optional<Ground> ground;
    Bodies bodies;
    std::vector<Panel> panels;
    std::vector<SunView> suns;     // one for each drawing of the frame
    std::vector<FrameView> views;  // likewise, all of one size
};

// The tiles in which a frame may look otherwise than the one before it. It is known from what the two show: a body
// that moves changes the tiles where it was and is, those where it darkens the ground, and what its shadow falls
// on.
Tiles changed_tiles(const FrameContents& before, const FrameContents& now);

}  // namespace pushfactor::renderer
