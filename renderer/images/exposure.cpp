#include "renderer/images/exposure.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace pushfactor::renderer {
namespace {

constexpr float straight = 0.6f;  // light below is not bent

}  // namespace

glm::vec3 exposed(const glm::vec3& light) {
    const glm::vec3 positive = glm::max(light, 0.0f);
    const float brightest = std::max({positive.r, positive.g, positive.b});
    if (brightest <= straight) return positive;
    const float excess = (brightest - straight) / (1.0f - straight);
    const float bent = straight + (1.0f - straight) * (1.0f - std::exp(-excess));
    return positive * (bent / brightest);
}

glm::vec3 unexposed(const glm::vec3& light) {
    const float bent = std::max({light.r, light.g, light.b});
    if (bent <= straight) return light;
    const float brightest = straight - (1.0f - straight) * std::log(1.0f - (bent - straight) / (1.0f - straight));
    return light * (brightest / bent);
}

}  // namespace pushfactor::renderer
