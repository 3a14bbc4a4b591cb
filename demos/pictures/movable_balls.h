// What a camera has to show of a scene.
#pragma once

#include "demos/pictures/framing.h"
#include "demos/runs/scene.h"

#include <vector>

namespace pushfactor::demos::pictures {

// Balls around the movable bodies of a scene in its current state, and the points that they hang on.
std::vector<Ball> movable_balls(const BuiltScene& scene);

}  // namespace pushfactor::demos::pictures
