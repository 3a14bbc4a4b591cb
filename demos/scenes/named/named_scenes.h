// Named scenes that are only that, one file each; those with more to offer have a header of their own.
#pragma once

#include "demos/scenes/parameters.h"
#include "demos/scenes/scene_description.h"

#include <span>

namespace pushfactor::demos::scenes {

SceneDescription stack(const ParameterValues& parameters);  // paper section 10.1
std::span<const Parameter> stack_parameters();
SceneDescription intersecting_stack(const ParameterValues& parameters);  // paper section 10.2
std::span<const Parameter> intersecting_stack_parameters();
SceneDescription pendulum_grid(const ParameterValues& parameters);  // paper section 10.3 and Figure 9
std::span<const Parameter> pendulum_grid_parameters();
SceneDescription pendulum_wave(const ParameterValues& parameters);  // paper section 10.3 and Figure 10
std::span<const Parameter> pendulum_wave_parameters();
SceneDescription chain(const ParameterValues& parameters);
std::span<const Parameter> chain_parameters();
SceneDescription heavy_on_light(const ParameterValues& parameters);
std::span<const Parameter> heavy_on_light_parameters();
SceneDescription dominoes(const ParameterValues& parameters);
std::span<const Parameter> dominoes_parameters();

}  // namespace pushfactor::demos::scenes
