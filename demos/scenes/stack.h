// The stack test, paper section 10.1.
#pragma once

#include "demos/parameters.h"
#include "demos/scene.h"

namespace pushfactor::demos::scenes {

std::span<const Parameter> stack_parameters();
Scene stack(const ParameterValues& parameters, const Settings& settings);

}  // namespace pushfactor::demos::scenes
