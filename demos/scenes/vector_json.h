// Vectors as JSON: three numbers.
#pragma once

#include "demos/text/json.h"
#include "engine/base/math.h"

namespace pushfactor::demos {

inline Json to_json(const engine::Vector3& v) {
    return Json::array({v.x(), v.y(), v.z()});
}

}  // namespace pushfactor::demos
