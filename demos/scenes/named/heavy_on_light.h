// A heavy cube on light ones.
#pragma once

#include "demos/scenes/parameters.h"
#include "demos/scenes/scene_description.h"

namespace pushfactor::demos::scenes {

std::span<const Parameter> heavy_on_light_parameters();
SceneDescription heavy_on_light(const ParameterValues& parameters);

}  // namespace pushfactor::demos::scenes
