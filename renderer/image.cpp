#include "renderer/image.h"

#include <cassert>
#include <cstddef>

namespace pushfactor::renderer {

std::array<std::uint8_t, 3> Image::pixel(int x, int y) const {
    assert(x >= 0 && x < width && y >= 0 && y < height);
    const auto first =
        3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
    return {rgb[first], rgb[first + 1], rgb[first + 2]};
}

Image image_from_bottom_up_rgba(int width, int height, std::span<const std::uint8_t> rgba) {
    const auto columns = static_cast<std::size_t>(width);
    const auto rows = static_cast<std::size_t>(height);
    assert(rgba.size() == 4 * columns * rows);

    Image image{width, height, std::vector<std::uint8_t>(3 * columns * rows)};
    std::uint8_t* to = image.rgb.data();
    for (std::size_t row = rows; row-- > 0;) {
        const std::uint8_t* from = &rgba[4 * columns * row];
        for (std::size_t column = 0; column < columns; ++column, from += 4, to += 3) {
            to[0] = from[0];
            to[1] = from[1];
            to[2] = from[2];
        }
    }
    return image;
}

}  // namespace pushfactor::renderer
