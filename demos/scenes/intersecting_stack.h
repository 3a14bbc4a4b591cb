// The intersecting stack test, paper section 10.2.
#pragma once

#include "demos/parameters.h"
#include "demos/scene.h"

namespace pushfactor::demos::scenes {

std::span<const Parameter> intersecting_stack_parameters();
Scene intersecting_stack(const ParameterValues& parameters, const Settings& settings);

}  // namespace pushfactor::demos::scenes
