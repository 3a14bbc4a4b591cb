// A hanging chain with a weight at its end.
#pragma once

#include "demos/scenes/parameters.h"
#include "demos/scenes/scene_description.h"

namespace pushfactor::demos::scenes {

std::span<const Parameter> chain_parameters();
SceneDescription chain(const ParameterValues& parameters);

}  // namespace pushfactor::demos::scenes
