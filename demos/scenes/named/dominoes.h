// A row of dominoes, the first one pushed over.
#pragma once

#include "demos/scenes/parameters.h"
#include "demos/scenes/scene_description.h"

namespace pushfactor::demos::scenes {

std::span<const Parameter> dominoes_parameters();
SceneDescription dominoes(const ParameterValues& parameters);

}  // namespace pushfactor::demos::scenes
