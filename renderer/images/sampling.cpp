#include "renderer/images/sampling.h"

#include "renderer/images/light_bytes.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace pushfactor::renderer {
namespace {

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

template <typename Visit>
void SampleMean::each_row(std::span<const PixelArea> areas, const Visit& visit) const {
    for (const PixelArea& area : areas) {
        for (int y = area.y; y < area.y + area.height; ++y) {
            const auto row = static_cast<std::size_t>(height_ - 1 - y) * static_cast<std::size_t>(width_);
            const std::size_t first = 3 * (row + static_cast<std::size_t>(area.x));
            visit(first, first + 3 * static_cast<std::size_t>(area.width));
        }
    }
}

void SampleMean::clear(std::span<const PixelArea> areas) {
    each_row(areas, [this](std::size_t first, std::size_t end) {
        std::fill(&sums_[first], &sums_[first] + (end - first), 0.0f);
    });
}

void SampleMean::add(const Image& image, std::span<const PixelArea> areas) {
    assert(image.rgb.size() == sums_.size());
    each_row(areas, [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) sums_[i] += light_of_byte(image.rgb[i]);
    });
}

void SampleMean::put(int count, std::span<const PixelArea> areas, Image& mean) const {
    assert(count > 0 && mean.rgb.size() == sums_.size());
    each_row(areas, [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) mean.rgb[i] = byte_of_light(sums_[i] / static_cast<float>(count));
    });
}

}  // namespace pushfactor::renderer
