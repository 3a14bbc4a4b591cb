#include "renderer/images/sampling.h"

#include "renderer/images/exposure.h"
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

// Height of the direction towards the sky of rendering `index`: half of them as dense as the cosine to the
// vertical, half evenly, so that their density over the solid angle is (1 + 2 height) / (4 pi).
float sky_height(int index, int count) {
    const double share = (index + 0.5) / count;
    return static_cast<float>(0.5 * (std::sqrt(1.0 + 8.0 * share) - 1.0));
}

float raw_weight(float height) {
    return 4.0f / (1.0f + 2.0f * height);
}

// What makes the weights of `count` directions light the ground exactly as the whole sky does.
float exactness(int count) {
    float sum = 0.0f;
    for (int i = 0; i < count; ++i) sum += sky_height(i, count) * raw_weight(sky_height(i, count));
    return static_cast<float>(count) / sum;
}

}  // namespace

SampleOffset sample_offset(int index, int count, const glm::vec3& towards_sun) {
    assert(index >= 0 && index < count);
    if (count == 1) return {glm::vec2(0.0f), towards_sun, glm::vec3(0.0f, 1.0f, 0.0f), 0.0f};
    const double i = index;
    // Multiples of the powers of 1/g, where g is the root of g^3 = g + 1, fill the square evenly.
    constexpr double g = 1.32471795724474602596;
    const glm::vec2 pixel(fraction(0.5 + i / g) - 0.5f, fraction(0.5 + i / (g * g)) - 0.5f);

    // Sunflower pattern: fills the disc evenly.
    const float disc = std::tan(glm::radians(1.5f));  // radius at a distance of 1
    const float radius = disc * static_cast<float>(std::sqrt((i + 0.5) / count));
    const float angle = 2.0f * std::numbers::pi_v<float> * fraction(i / std::numbers::phi);
    const glm::vec3 beside =
        std::abs(towards_sun.y) < 0.9f ? glm::vec3(0.0f, 1.0f, 0.0f) : glm::vec3(1.0f, 0.0f, 0.0f);
    const glm::vec3 right = glm::normalize(glm::cross(beside, towards_sun));
    const glm::vec3 up = glm::cross(towards_sun, right);
    const float height = sky_height(index, count);
    const float level = std::sqrt(1.0f - height * height);
    return {.pixel = pixel,
            .towards_sun = glm::normalize(towards_sun + radius * (std::cos(angle) * right + std::sin(angle) * up)),
            .towards_sky = {level * std::cos(angle), height, level * std::sin(angle)},
            .sky_weight = exactness(count) * raw_weight(height)};
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

void SampleMean::add(std::span<const float> rgba, const PixelArea& area) {
    assert(rgba.size() == 4 * static_cast<std::size_t>(area.width) * static_cast<std::size_t>(area.height));
    const float* light = rgba.data();
    each_row(std::span(&area, 1), [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; i += 3, light += 4) {
            sums_[i] += light[0];
            sums_[i + 1] += light[1];
            sums_[i + 2] += light[2];
        }
    });
}

void SampleMean::put(int count, std::span<const PixelArea> areas, Image& mean) const {
    assert(count > 0 && mean.rgb.size() == sums_.size());
    const float share = 1.0f / static_cast<float>(count);
    each_row(areas, [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; i += 3) {
            const glm::vec3 light = exposed(share * glm::vec3(sums_[i], sums_[i + 1], sums_[i + 2]));
            for (int channel = 0; channel < 3; ++channel) {
                mean.rgb[i + static_cast<std::size_t>(channel)] = byte_of_light(light[channel]);
            }
        }
    });
}

}  // namespace pushfactor::renderer
