// The five regular solids.
#pragma once

#include "engine/base/math.h"

#include <array>
#include <string_view>
#include <vector>

namespace pushfactor::demos::scenes {

struct RegularSolid {
    std::string_view name;                // "tetrahedron"
    std::vector<engine::Vector3> points;  // m, at a distance of 1 from the origin
};
const std::array<RegularSolid, 5>& regular_solids();

}  // namespace pushfactor::demos::scenes
