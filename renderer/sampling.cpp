#include "renderer/sampling.h"

#include <glm/geometric.hpp>
#include <glm/gtc/color_space.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace pushfactor::renderer {
namespace {

// Linear light of `level` 255ths of full brightness in sRGB.
float linear(float level) {
    return glm::convertSRGBToLinear(glm::vec3(level / 255.0f)).x;
}

const std::array<float, 256> light_of_byte = [] {
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

float fraction(double x) {
    return static_cast<float>(x - std::floor(x));
}

}  // namespace

SampleOffset sample_offset(int index, int count, const glm::vec3& towards_sun) {
    assert(index >= 0 && index < count);
    if (count == 1) return {glm::vec2(0.0f), towards_sun};
    const double i = index;
    // Multiples of the powers of 1/g, where g is the root of g^3 = g + 1, fill the square evenly.
    constexpr double g = 1.32471795724474602596;
    const glm::vec2 pixel(fraction(0.5 + i / g) - 0.5f, fraction(0.5 + i / (g * g)) - 0.5f);

    // A sunflower's seeds fill the disc evenly.
    const float disc = std::tan(glm::radians(1.5f));  // radius at a distance of 1
    const float radius = disc * static_cast<float>(std::sqrt((i + 0.5) / count));
    const float angle = 2.0f * std::numbers::pi_v<float> * fraction(i / std::numbers::phi);
    const glm::vec3 beside =
        std::abs(towards_sun.y) < 0.9f ? glm::vec3(0.0f, 1.0f, 0.0f) : glm::vec3(1.0f, 0.0f, 0.0f);
    const glm::vec3 right = glm::normalize(glm::cross(beside, towards_sun));
    const glm::vec3 up = glm::cross(towards_sun, right);
    return {pixel, glm::normalize(towards_sun + radius * (std::cos(angle) * right + std::sin(angle) * up))};
}

SampleMean::SampleMean(int width, int height)
    : width_(width),
      height_(height),
      sums_(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

void SampleMean::add(const Image& image) {
    assert(image.rgb.size() == sums_.size());
    for (std::size_t i = 0; i < sums_.size(); ++i) sums_[i] += light_of_byte[image.rgb[i]];
    ++count_;
}

Image SampleMean::mean() const {
    assert(count_ > 0);
    Image image{width_, height_, std::vector<std::uint8_t>(sums_.size())};
    std::ranges::transform(sums_, image.rgb.begin(), [this](float sum) {
        const auto byte = std::ranges::upper_bound(next_byte, sum / static_cast<float>(count_)) - next_byte.begin();
        return static_cast<std::uint8_t>(byte);
    });
    return image;
}

}  // namespace pushfactor::renderer
