// FLIP: the difference that a person sees who swaps two images on a screen. P. Andersson, J. Nilsson,
// T. Akenine-Möller, M. Oskarsson, K. Åström, M. Fairchild, "FLIP: A Difference Evaluator for Alternating Images",
// Proceedings of the ACM on Computer Graphics and Interactive Techniques 3(2), 2020; for images of low dynamic
// range.
#pragma once

#include "renderer/images/image.h"

#include <vector>

namespace pushfactor::renderer {

// A screen of 3840 pixels on 0.7 m, seen from 0.7 m (section 4 of the paper).
inline constexpr float flip_pixels_per_degree = 67.02f;

// Error of each pixel, 0 (not seen) .. 1, rows from top to bottom. Both images must have the same size.
std::vector<float> flip(const Image& expected, const Image& actual,
                        float pixels_per_degree = flip_pixels_per_degree);

}  // namespace pushfactor::renderer
