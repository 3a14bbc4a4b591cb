#pragma once

#include "renderer/images/image.h"

#include <cstdint>
#include <span>
#include <string>

namespace pushfactor::renderer {

// Decodes a PNG file of any kind as 8-bit sRGB; what is transparent is shown on white. Throws
// RendererError for bytes that are not a whole PNG file, and for more than 268 million pixels.
Image decode_png(std::span<const std::uint8_t> png);

// The opacity of its pixels as grey: white is opaque. Throws as decode_png().
Image decode_opacity(std::span<const std::uint8_t> png);

// Whether the file says how opaque its pixels are. False for bytes that are no PNG file.
bool has_opacity(std::span<const std::uint8_t> png);

// PngNotes::film, in a chunk with this key; empty where there is none.
inline constexpr const char* film_key = "Film";
std::string film_in_png(std::span<const std::uint8_t> png);

}  // namespace pushfactor::renderer
