// The intersecting stack test, paper section 10.2.
#pragma once

#include "demos/scenes/parameters.h"
#include "demos/scenes/scene_description.h"

namespace pushfactor::demos::scenes {

std::span<const Parameter> intersecting_stack_parameters();
SceneDescription intersecting_stack(const ParameterValues& parameters);

}  // namespace pushfactor::demos::scenes
