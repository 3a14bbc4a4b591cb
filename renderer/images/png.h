#pragma once

#include "renderer/images/image.h"

#include <cstdint>
#include <vector>

namespace pushfactor::renderer {

// The bytes of a PNG file (8 bits a channel, RGB) that shows `image`. May be called from several threads.
// Throws RendererError when the image is empty or its bytes do not fit its size.
std::vector<std::uint8_t> encode_png(const Image& image);

}  // namespace pushfactor::renderer
