// The funnel, paper section 10.3 and Figure 8.
#pragma once

#include "demos/scenes/parameters.h"
#include "demos/scenes/scene_description.h"

namespace pushfactor::demos::scenes {

std::span<const Parameter> funnel_parameters();
SceneDescription funnel(const ParameterValues& parameters);

}  // namespace pushfactor::demos::scenes
