// The stack test, paper section 10.1.
#pragma once

#include "demos/scenes/parameters.h"
#include "demos/scenes/scene_description.h"

namespace pushfactor::demos::scenes {

std::span<const Parameter> stack_parameters();
SceneDescription stack(const ParameterValues& parameters);

}  // namespace pushfactor::demos::scenes
