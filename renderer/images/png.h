#pragma once

#include "renderer/images/image.h"

#include <cstdint>
#include <vector>

namespace pushfactor::renderer {

// Encodes `image` as a PNG file (RGB, 8 bits per channel). Thread-safe. Throws RendererError if the image is empty
// or its bytes do not match its size.
std::vector<std::uint8_t> encode_png(const Image& image);

}  // namespace pushfactor::renderer
