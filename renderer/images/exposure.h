#pragma once

#include <glm/vec3.hpp>

namespace pushfactor::renderer {

// Bends bright light towards 1 instead of cutting it off, all channels alike so that the hue stays; negative light
// becomes 0. assets/shaders/exposed.frag does the same to frames that are rendered once.
glm::vec3 exposed(const glm::vec3& light);

// The light that exposed() makes `light`, whose channels are 0 to below 1.
glm::vec3 unexposed(const glm::vec3& light);

}  // namespace pushfactor::renderer
