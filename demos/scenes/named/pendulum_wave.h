// The pendulum wave, paper section 10.3 and Figure 10.
#pragma once

#include "demos/scenes/parameters.h"
#include "demos/scenes/scene_description.h"

namespace pushfactor::demos::scenes {

std::span<const Parameter> pendulum_wave_parameters();
SceneDescription pendulum_wave(const ParameterValues& parameters);

}  // namespace pushfactor::demos::scenes
