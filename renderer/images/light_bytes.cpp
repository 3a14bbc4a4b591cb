#include "renderer/images/light_bytes.h"

#include <glm/common.hpp>
#include <glm/gtc/color_space.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace pushfactor::renderer {
namespace {

// Linear light of `level` 255ths of full brightness in sRGB.
float linear(float level) {
    return glm::convertSRGBToLinear(glm::vec3(level / 255.0f)).x;
}

const std::array<float, 256> lights = [] {
    std::array<float, 256> light{};
    for (std::size_t i = 0; i < light.size(); ++i) light[i] = linear(static_cast<float>(i));
    return light;
}();

// Element i is the light from which on a byte is rounded up from i to i + 1.
const std::array<float, 255> next_byte = [] {
    std::array<float, 255> light{};
    for (std::size_t i = 0; i < light.size(); ++i) light[i] = linear(static_cast<float>(i) + 0.5f);
    return light;
}();

}  // namespace

float light_of_byte(std::uint8_t byte) {
    return lights[byte];
}

std::uint8_t byte_of_light(float light) {
    return static_cast<std::uint8_t>(std::ranges::upper_bound(next_byte, light) - next_byte.begin());
}

}  // namespace pushfactor::renderer
