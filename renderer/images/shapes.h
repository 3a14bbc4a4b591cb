#pragma once

#include "renderer/images/image.h"
#include "renderer/images/paint.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <cstddef>

namespace pushfactor::renderer {

// The shapes that are drawn flat, and how they become pixels. All coordinates are pixels from the image's upper
// left corner, x right, y down. All numbers are finite.
//
// A shape has `bounds()`, which hold all of it, and `coverage(point)`: how much of the pixel whose centre is
// `point` it covers. Above 1 means all of it. At -d no pixel within d of that one is covered either.

struct Bounds {
    glm::dvec2 low;
    glm::dvec2 high;
};

// A line with round ends; a disc where its two ends are the same point.
class Capsule {
  public:
    // Width in pixels; at 0 or below nothing is covered.
    Capsule(const glm::dvec2& from, const glm::dvec2& to, double width);

    Bounds bounds() const;
    double coverage(const glm::dvec2& point) const;

  private:
    glm::dvec2 from_;
    glm::dvec2 to_;
    double width_;
};

// A shaft that is round at its start, and a triangular head whose tip is the end.
class ArrowShape {
  public:
    // From one point to another one. `width` is that of the shaft and `grown` how far the outline is moved
    // outwards, px. An arrow shorter than two heads is a smaller one of the same proportions.
    ArrowShape(const glm::dvec2& from, const glm::dvec2& to, double width, double grown = 0.0);

    Bounds bounds() const;
    double coverage(const glm::dvec2& point) const;

  private:
    ArrowShape(const glm::dvec2& from, const glm::dvec2& to, double width, double grown, double length);

    Capsule shaft_;
    glm::dvec2 tip_;
    glm::dvec2 backwards_;  // from the tip along the shaft, unit length
    double head_length_;
    double head_half_breadth_;
    double grown_;
};

// The pixels of an image that something touches: columns [first_x, end_x) and rows [first_y, end_y).
struct PixelRange {
    int first_x = 0;
    int end_x = 0;
    int first_y = 0;
    int end_y = 0;
};
PixelRange pixels_within(const Bounds& bounds, const Image& image);

// Draws a shape; what lies outside of the image is cut off.
template <typename Shape>
void draw_shape(Image& image, const Shape& shape, const Paint& paint) {
    const Ink ink(paint);
    const PixelRange range = pixels_within(shape.bounds(), image);
    if (!ink.visible() || range.first_x >= range.end_x) return;
    for (int y = range.first_y; y < range.end_y; ++y) {
        std::uint8_t* row = &image.rgb[3 * static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width)];
        for (int x = range.first_x; x < range.end_x; ++x) {
            const double coverage = shape.coverage(glm::dvec2(x, y) + 0.5);
            if (coverage > 0.0) {
                ink.put(row + 3 * static_cast<std::ptrdiff_t>(x), static_cast<float>(std::min(coverage, 1.0)));
            } else {
                // The bounds of a slanting line hold little else than empty pixels.
                x += static_cast<int>(std::min(-coverage, static_cast<double>(range.end_x - x)));
            }
        }
    }
}

}  // namespace pushfactor::renderer
