#include "renderer/images/paint.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace pushfactor::renderer {

Ink::Ink(const Paint& paint)
    : colour_(255.0f * glm::clamp(paint.colour, 0.0f, 1.0f)), opacity_(std::clamp(paint.opacity, 0.0f, 1.0f)) {
    const glm::vec3& colour = paint.colour;
    const bool finite = std::isfinite(colour.r) && std::isfinite(colour.g) && std::isfinite(colour.b) &&
                        std::isfinite(paint.opacity);
    if (!finite) {
        colour_ = glm::vec3(0.0f);
        opacity_ = 0.0f;
    }
}

}  // namespace pushfactor::renderer
