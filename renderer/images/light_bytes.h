#pragma once

#include <cstdint>

namespace pushfactor::renderer {

// Linear light, 0..1, for an sRGB byte.
float light_of_byte(std::uint8_t byte);

// The sRGB byte for a linear light, rounded in sRGB.
std::uint8_t byte_of_light(float light);

}  // namespace pushfactor::renderer
