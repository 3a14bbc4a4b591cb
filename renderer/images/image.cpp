#include "renderer/images/image.h"

#include <cassert>
#include <cstddef>

namespace pushfactor::renderer {

std::array<std::uint8_t, 3> Image::pixel(int x, int y) const {
    assert(x >= 0 && x < width && y >= 0 && y < height);
    const auto first =
        3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
    return {rgb[first], rgb[first + 1], rgb[first + 2]};
}

}  // namespace pushfactor::renderer
