// The tosses as this engine computes them.
#pragma once

#include "demos/reports/reality/tosses.h"
#include "demos/scenes/scene_description.h"

namespace pushfactor::demos::reports::reality {

// One pose per frame, the start first.
std::vector<Pose> computed(const Restart& start, const Law& law, std::size_t frames);

// The scene that gives the poses of computed(), with the measured motion of the cube.
SceneDescription scene_of(const Toss& toss, const Law& law);

}  // namespace pushfactor::demos::reports::reality
