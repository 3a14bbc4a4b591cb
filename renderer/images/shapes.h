#pragma once

#include "renderer/images/image.h"
#include "renderer/images/paint.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <cstddef>

namespace pushfactor::renderer {

// 2D shapes and their rasterisation. All coordinates in pixels from the image's upper left corner, x right, y down;
// all finite.
//
// A shape has `bounds()`, which contain it, and `coverage(point)`: the covered share of the pixel with centre
// `point`. Values above 1 mean full coverage; -d means that no pixel within d of that one is covered either.

struct Bounds {
    glm::dvec2 low;
    glm::dvec2 high;
};

// A line with round ends; a disc if both end points are equal.
class Capsule {
  public:
    // Width in pixels; covers nothing if <= 0.
    Capsule(const glm::dvec2& from, const glm::dvec2& to, double width);

    Bounds bounds() const;
    double coverage(const glm::dvec2& point) const;

  private:
    glm::dvec2 from_;
    glm::dvec2 to_;
    double width_;
};

// An arrow: a shaft with a round start, and a triangular head whose tip is the end.
class ArrowShape {
  public:
    // `width` is that of the shaft, `grown` an outward offset of the outline, px. An arrow shorter than two heads
    // is scaled down with the same proportions.
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

// Pixels of an image that may be touched: columns [first_x, end_x) and rows [first_y, end_y).
struct PixelRange {
    int first_x = 0;
    int end_x = 0;
    int first_y = 0;
    int end_y = 0;
};
PixelRange pixels_within(const Bounds& bounds, const Image& image);

// Draws a shape, clipped to the image.
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
                // Skip ahead: the bounds of a diagonal line contain mostly empty pixels.
                x += static_cast<int>(std::min(-coverage, static_cast<double>(range.end_x - x)));
            }
        }
    }
}

}  // namespace pushfactor::renderer
