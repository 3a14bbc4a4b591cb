// The funnel, paper section 10.3 and Figure 8.
#pragma once

#include "demos/scenes/parameters.h"
#include "demos/scenes/random.h"
#include "demos/scenes/scene_description.h"

#include <vector>

namespace pushfactor::demos::scenes {

std::span<const Parameter> funnel_parameters();
SceneDescription funnel(const ParameterValues& parameters);

// The four planes, as bodies without mass.
void add_funnel_planes(SceneDescription& scene, double mu);

// Centres [m] of `count` bodies that reach `reach` [m] from theirs: square layers as wide as the funnel at their
// height, each body a little off its place.
std::vector<engine::Vector3> funnel_places(int count, double reach, Random& random);

// Of a heap of `count` bodies of the volume of a ball of 0.5 m.
View view_into_funnel(int count);

}  // namespace pushfactor::demos::scenes
