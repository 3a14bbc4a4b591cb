// Converts Eigen to GLM types and back, here alone: double to float, the same frames and units.
#pragma once

#include "demos/base/text/palette.h"
#include "engine/base/math.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace pushfactor::demos::pictures {

inline glm::vec3 to_glm(const engine::Vector3& v) {
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

inline glm::quat to_glm(const engine::Quaternion& q) {
    return {static_cast<float>(q.w()), static_cast<float>(q.x()), static_cast<float>(q.y()),
            static_cast<float>(q.z())};
}

inline glm::vec3 to_glm(const Colour& colour) {
    return {colour.red, colour.green, colour.blue};
}

inline engine::Vector3 to_eigen(const glm::vec3& v) {
    return {v.x, v.y, v.z};
}

}  // namespace pushfactor::demos::pictures
