// A hanging chain with a weight at its end.
#pragma once

#include "demos/parameters.h"
#include "demos/scene_description.h"

namespace pushfactor::demos::scenes {

std::span<const Parameter> chain_parameters();
SceneDescription chain(const ParameterValues& parameters);

}  // namespace pushfactor::demos::scenes
