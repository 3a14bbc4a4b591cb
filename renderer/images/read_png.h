#pragma once

#include "renderer/images/image.h"

#include <cstdint>
#include <span>
#include <string>

namespace pushfactor::renderer {

enum class Behind { white, black };

// Decodes a PNG file of any kind as 8-bit sRGB; what is transparent is shown on white or black. Throws
// RendererError for bytes that are not a whole PNG file, and for more than 268 million pixels.
Image decode_png(std::span<const std::uint8_t> png, Behind behind = Behind::white);

// Whether the file says how opaque its pixels are. False for bytes that are no PNG file.
bool has_opacity(std::span<const std::uint8_t> png);

// PngNotes::film, in a chunk with this key; empty where there is none.
inline constexpr const char* film_key = "Film";
std::string film_in_png(std::span<const std::uint8_t> png);

}  // namespace pushfactor::renderer
