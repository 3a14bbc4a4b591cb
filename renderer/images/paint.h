#pragma once

#include <glm/vec3.hpp>

#include <cmath>
#include <cstdint>

namespace pushfactor::renderer {

// What flat things are drawn with.
struct Paint {
    glm::vec3 colour{0.0f};  // sRGB, each 0..1; what lies outside counts as the nearer end
    float opacity = 1.0f;    // 0..1, likewise
};

// A paint made ready for bytes. One that is not finite is invisible.
class Ink {
  public:
    explicit Ink(const Paint& paint);

    bool visible() const { return opacity_ > 0.0f; }

    // Blends with a pixel's three bytes, of which `coverage` (0..1) is covered. The blending is done in sRGB: it
    // is not what light does, but text keeps the weight that people know from screens.
    void put(std::uint8_t* pixel, float coverage) const {
        const float share = opacity_ * coverage;
        for (int channel = 0; channel < 3; ++channel) {
            const auto before = static_cast<float>(pixel[channel]);
            pixel[channel] = static_cast<std::uint8_t>(std::lround(before + share * (colour_[channel] - before)));
        }
    }

  private:
    glm::vec3 colour_;  // 0..255
    float opacity_;     // 0..1
};

}  // namespace pushfactor::renderer
