#pragma once

#include "renderer/image.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

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

    void add(const Image& image);

    // The mean of the images added, of which there is at least one.
    Image mean() const;

  private:
    int width_;
    int height_;
    int count_ = 0;
    std::vector<float> sums_;  // linear light, in the order of the image's bytes
};

}  // namespace pushfactor::renderer
