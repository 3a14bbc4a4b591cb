// The five regular solids, poured into the funnel.
#pragma once

#include "demos/scenes/parameters.h"
#include "demos/scenes/scene_description.h"

#include <array>
#include <string_view>
#include <vector>

namespace pushfactor::demos::scenes {

struct RegularSolid {
    std::string_view name;                // "tetrahedron"
    std::vector<engine::Vector3> points;  // m, at a distance of 1 from the origin
};
const std::array<RegularSolid, 5>& regular_solids();

std::span<const Parameter> platonic_parameters();
SceneDescription platonic(const ParameterValues& parameters);

}  // namespace pushfactor::demos::scenes
