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
    glm::vec3 towards_sky;  // unit length, upwards
    float sky_weight;       // irradiance of a sky of radiance 1 from there, in its normal plane, divided by pi
};

// Offset of rendering `index` of `count`, 0 <= index < count. The renderings cover the pixel, and the disc of a sun
// a few times as wide as the real one, evenly and deterministically; a single one has no offset. Their directions
// cover the sky: as seen from above as densely as the cosine to the vertical for one half, evenly for the other,
// which upright walls need. Sums over them have the mean weight of a sky; that of the ground is exact.
SampleOffset sample_offset(int index, int count, const glm::vec3& towards_sun);

// Mean of renderings in linear light, in the memory of one image for any number of them.
class SampleMean {
  public:
    // Size of all images, pixels.
    SampleMean(int width, int height);

    // Resets these areas.
    void clear(std::span<const PixelArea> areas);

    // Adds one area of a rendering, `rgba` with four floats per pixel, rows from bottom to top; every area must be
    // added equally often.
    void add(std::span<const float> rgba, const PixelArea& area);

    // Writes the mean of `count` additions, exposed, into these areas of `mean`.
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
