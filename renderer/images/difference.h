// How far two images differ, by pixel: the largest difference of its three channels, in levels of 0..255.
#pragma once

#include "renderer/images/image.h"

#include <array>

namespace pushfactor::renderer {

class ImageDifference {
  public:
    // Both images must have the same size.
    ImageDifference(const Image& a, const Image& b);

    int largest() const;                  // level
    double share_above(int level) const;  // of the pixels that differ by more than `level`, 0..1
    long pixels_above(int level) const;
    double rms() const { return rms_; }  // levels, over all channels
    double similarity() const;           // peak signal-to-noise ratio [dB]; infinite for equal images

    bool any() const { return largest() > 0; }

  private:
    std::array<long, 256> pixels_{};  // by level
    long count_ = 0;
    double rms_ = 0.0;
};

// The pixels that differ, from dark red for one level over orange to white for 255, over a faint grey `a`.
Image heat_map(const Image& a, const Image& b);

// The same for errors given per pixel, 0..1.
Image heat_map(const Image& a, const std::vector<float>& errors);

}  // namespace pushfactor::renderer
