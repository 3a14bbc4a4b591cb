#pragma once

#include "renderer/images/image.h"

#include <cstdint>
#include <span>

namespace pushfactor::renderer {

// Decodes a PNG file of any kind as 8-bit sRGB; what is transparent is shown on white. Throws RendererError for
// bytes that are not a whole PNG file, and for more than 268 million pixels.
Image decode_png(std::span<const std::uint8_t> png);

}  // namespace pushfactor::renderer
