#pragma once

#include "renderer/images/image.h"
#include "renderer/images/tiles.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace pushfactor::renderer {

// By how much one of several draws of a frame is moved.
struct SampleOffset {
    glm::vec2 pixel;        // of the picture, pixels, each -0.5..0.5
    glm::vec3 towards_sun;  // unit length
};

// The offset of draw `index` of `count`, 0 <= index < count. The draws cover the pixel, and the disc of a sun a
// few times as wide as the real one, evenly and always in the same way; a single one is not moved.
SampleOffset sample_offset(int index, int count, const glm::vec3& towards_sun);

// The mean of images in linear light. It needs the memory of one, however many they are.
class SampleMean {
  public:
    // All images have this size, pixels.
    SampleMean(int width, int height);

    // Forgets what was added in these areas.
    void clear(std::span<const PixelArea> areas);

    // Adds these areas of an image; every image must be added with the same areas.
    void add(const Image& image, std::span<const PixelArea> areas);

    // Puts the mean of `count` images that were added into these areas of `mean`.
    void put(int count, std::span<const PixelArea> areas, Image& mean) const;

  private:
    // Calls `visit(first, end)` with indices of the bytes of each row of each area.
    template <typename Visit>
    void each_row(std::span<const PixelArea> areas, const Visit& visit) const;

    int width_;
    int height_;
    std::vector<float> sums_;  // linear light, in the order of an image's bytes
};

}  // namespace pushfactor::renderer
