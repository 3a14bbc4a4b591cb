#pragma once

#include "renderer/images/image.h"
#include "renderer/images/tiles.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace pushfactor::renderer {

// Offset of one of several renderings of a frame.
struct SampleOffset {
    glm::vec2 pixel;        // shift of the picture, pixels, each -0.5..0.5
    glm::vec3 towards_sun;  // unit length
};

// Offset of rendering `index` of `count`, 0 <= index < count. The renderings cover the pixel, and the disc of a sun
// a few times as wide as the real one, evenly and deterministically; a single one has no offset.
SampleOffset sample_offset(int index, int count, const glm::vec3& towards_sun);

// Mean of images in linear light, in the memory of one image for any number of them.
class SampleMean {
  public:
    // Size of all images, pixels.
    SampleMean(int width, int height);

    // Resets these areas.
    void clear(std::span<const PixelArea> areas);

    // Adds these areas of an image; all images must be added with the same areas.
    void add(const Image& image, std::span<const PixelArea> areas);

    // Writes the mean of the `count` added images into these areas of `mean`.
    void put(int count, std::span<const PixelArea> areas, Image& mean) const;

  private:
    // Calls `visit(first, end)` with the byte indices of each row of each area.
    template <typename Visit>
    void each_row(std::span<const PixelArea> areas, const Visit& visit) const;

    int width_;
    int height_;
    std::vector<float> sums_;  // linear light, in the order of an image's bytes
};

}  // namespace pushfactor::renderer
