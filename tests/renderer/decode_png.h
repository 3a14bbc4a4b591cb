#pragma once

#include "renderer/images/image.h"

#include <cstdint>
#include <vector>

namespace pushfactor::renderer {

// The image in the bytes of a PNG file. Throws std::runtime_error when there is none, or it is not plain RGB.
Image decode_png(const std::vector<std::uint8_t>& png);

}  // namespace pushfactor::renderer
