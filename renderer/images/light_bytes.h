#pragma once

#include <cstdint>

namespace pushfactor::renderer {

// Linear light, 0..1, of a byte in sRGB.
float light_of_byte(std::uint8_t byte);

// The byte whose light is nearest, as bytes are rounded in sRGB.
std::uint8_t byte_of_light(float light);

}  // namespace pushfactor::renderer
