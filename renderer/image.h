#pragma once

#include <array>
#include <cstdint>
#include <span>
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

// An image of what GL reads back: four bytes a pixel, of which the last is dropped, rows from bottom to top.
// `rgba` holds 4 * width * height bytes.
Image image_from_bottom_up_rgba(int width, int height, std::span<const std::uint8_t> rgba);

}  // namespace pushfactor::renderer
