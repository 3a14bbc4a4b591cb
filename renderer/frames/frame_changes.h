#pragma once

#include "renderer/frames/frame_plan.h"
#include "renderer/picture/bodies.h"
#include "renderer/picture/picture.h"
#include "renderer/picture/views.h"

#include <optional>
#include <vector>

namespace pushfactor::renderer {

// Everything that determines a frame, without the marks drawn over it.
struct FrameContents {
    Camera camera;
    Background background;
    std::optional<Ground> ground;
    Bodies bodies;
    std::vector<Panel> panels;
    std::vector<SunView> suns;     // one per rendering of the frame
    std::vector<FrameView> views;  // likewise; all of one size
    std::vector<SkyView> skies;    // likewise; none for a single rendering, which has the light of an open sky
};

// Tiles in which a frame may differ from the previous one, from the contents of both: a moving body changes the
// tiles of its old and new positions, those where it darkens the ground, and those that its shadow falls on.
Tiles changed_tiles(const FrameContents& before, const FrameContents& now);

}  // namespace pushfactor::renderer
