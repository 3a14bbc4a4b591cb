#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace pushfactor::renderer {

// A picture as bytes: sRGB, three bytes a pixel, rows from top to bottom without padding.
struct Image {
    int width = 0;   // pixels
    int height = 0;  // pixels
    std::vector<std::uint8_t> rgb;

    // Red, green and blue of a pixel; x in [0, width) from the left, y in [0, height) from the top.
    std::array<std::uint8_t, 3> pixel(int x, int y) const;

    bool operator==(const Image&) const = default;
};

}  // namespace pushfactor::renderer
