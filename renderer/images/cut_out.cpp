#include "renderer/images/cut_out.h"

#include "renderer/base/renderer_error.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pushfactor::renderer {

// Over a background b a pixel of colour c and opacity a shows a c + (1 - a) b, so two backgrounds give a and c.
CutOut cut_out(const Image& on_dark, const glm::vec3& dark, const Image& on_light, const glm::vec3& light) {
    if (on_dark.width != on_light.width || on_dark.height != on_light.height) {
        throw RendererError("two images to cut out of must have the same size");
    }
    CutOut result{.width = on_dark.width, .height = on_dark.height};
    const std::size_t count = on_dark.rgb.size() / 3;
    result.rgba.resize(4 * count);
    for (std::size_t pixel = 0; pixel < count; ++pixel) {
        float through = 0.0f;  // 1 - a
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t i = 3 * pixel + k;
            const float apart = 255.0f * (light[static_cast<int>(k)] - dark[static_cast<int>(k)]);
            through += static_cast<float>(on_light.rgb[i] - on_dark.rgb[i]) / (3.0f * apart);
        }
        const float opacity = std::clamp(1.0f - through, 0.0f, 1.0f);
        const auto byte = [](float value) {
            return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0f, 255.0f)));
        };
        result.rgba[4 * pixel + 3] = byte(255.0f * opacity);
        if (opacity < 0.5f / 255.0f) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const float behind = 255.0f * (1.0f - opacity) * dark[static_cast<int>(k)];
            result.rgba[4 * pixel + k] = byte((static_cast<float>(on_dark.rgb[3 * pixel + k]) - behind) / opacity);
        }
    }
    return result;
}

}  // namespace pushfactor::renderer
