// The pendulum grid, paper section 10.3 and Figure 9.
#pragma once

#include "demos/scenes/parameters.h"
#include "demos/scenes/scene_description.h"

namespace pushfactor::demos::scenes {

std::span<const Parameter> pendulum_grid_parameters();
SceneDescription pendulum_grid(const ParameterValues& parameters);

}  // namespace pushfactor::demos::scenes
