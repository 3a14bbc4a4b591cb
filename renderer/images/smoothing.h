#pragma once

#include "renderer/images/image.h"
#include "renderer/images/tiles.h"

#include <cstdint>
#include <span>

namespace pushfactor::renderer {

// Largest distance at which a pixel influences the smoothing of another, pixels.
constexpr int smoothing_reach = 16;

// Smooths the edges of an image drawn with one sample per pixel: follows a brightness step along a row or column of
// pixels to both ends, which gives the position of the edge in the pixels between and the share of each that
// belongs to its neighbour. After Reshetov's morphological antialiasing (2009) and Lottes' FXAA (2009), here on the
// CPU and mixed in linear light.
//
// `rgba` is the whole image as read back from GL: rows from bottom to top, four bytes per pixel. Only edges with
// alpha not 0 on either side are smoothed; lines drawn with smooth edges stay crisp. Writes the pixels of `areas`
// into `image`, which has the size of the whole image; also reads `rgba` around them, up to smoothing_reach.
void smooth_edges(std::span<const std::uint8_t> rgba, std::span<const PixelArea> areas, Image& image);

}  // namespace pushfactor::renderer
