// The difference of two images, and its limits.
#pragma once

#include "renderer/images/image.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>

namespace pushfactor::renderer {

struct ImageDifference {
    double seen;        // part of the pixels with a channel that differs by more than 2 levels, 0..1
    double large;       // the same for more than 16 levels
    double similarity;  // peak signal-to-noise ratio, dB; infinite for equal images
};

// Of two images of the same size.
inline ImageDifference image_difference(const Image& a, const Image& b) {
    int seen = 0;
    int large = 0;
    double squares = 0.0;
    for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
        int largest = 0;
        for (std::size_t k = i; k < i + 3; ++k) {
            const int difference = std::abs(a.rgb[k] - b.rgb[k]);
            largest = std::max(largest, difference);
            squares += difference * difference;
        }
        seen += largest > 2 ? 1 : 0;
        large += largest > 16 ? 1 : 0;
    }
    const auto channels = static_cast<double>(a.rgb.size());
    const double similarity = squares > 0.0 ? 10.0 * std::log10(255.0 * 255.0 * channels / squares)
                                            : std::numeric_limits<double>::infinity();
    return {3.0 * seen / channels, 3.0 * large / channels, similarity};
}

// Other processors round some pixels on edges differently; more than that is a different picture.
inline bool same_to_the_eye(const ImageDifference& difference) {
    return difference.seen <= 0.002 && difference.large <= 0.0002 && difference.similarity >= 50.0;
}

// Bright where the images differ.
inline Image picture_of_difference(const Image& a, const Image& b) {
    constexpr int amplification = 16;
    Image picture = a;
    for (std::size_t i = 0; i < a.rgb.size(); ++i) {
        picture.rgb[i] = static_cast<std::uint8_t>(std::min(amplification * std::abs(a.rgb[i] - b.rgb[i]), 255));
    }
    return picture;
}

}  // namespace pushfactor::renderer
