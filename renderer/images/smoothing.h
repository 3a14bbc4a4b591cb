#pragma once

#include "renderer/images/image.h"
#include "renderer/images/tiles.h"

#include <cstdint>
#include <span>

namespace pushfactor::renderer {

// How far a pixel can be from what smoothing makes of it, pixels.
constexpr int smoothing_reach = 16;

// Smooths the edges of an image that was drawn with one sample a pixel: where the brightness changes along a row or
// a column of pixels, it follows that step to both ends, which tells how the edge runs through the pixels in
// between and how much of each it leaves to its neighbour. The idea is that of Reshetov's morphological
// antialiasing (2009) and of Lottes' FXAA (2009), here on the CPU and mixed in linear light.
//
// `rgba` is what GL reads back of the whole image: rows from bottom to top, four bytes a pixel. Only where the
// fourth is not 0, or on the other side of such an edge, anything is smoothed; lines that are drawn smooth stay as
// crisp as they are. The pixels of `areas` are put into `image`, which has the size of the whole; around them, up
// to the reach, `rgba` is read too.
void smooth_edges(std::span<const std::uint8_t> rgba, std::span<const PixelArea> areas, Image& image);

}  // namespace pushfactor::renderer
