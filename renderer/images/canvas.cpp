#include "renderer/images/canvas.h"

#include "renderer/base/renderer_error.h"
#include "renderer/images/shapes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace pushfactor::renderer {
namespace {

template <typename... Numbers>
bool finite(Numbers... numbers) {
    return (std::isfinite(numbers) && ...);
}
bool finite(const glm::vec2& v) {
    return finite(v.x, v.y);
}
bool finite(const Rectangle& rectangle) {
    return finite(rectangle.x, rectangle.y, rectangle.width, rectangle.height);
}

// How much of the pixel around `centre` lies between two positions.
double overlap(double low, double high, double centre) {
    return std::clamp(std::min(high, centre + 0.5) - std::max(low, centre - 0.5), 0.0, 1.0);
}

class SharpBox {
  public:
    // Empty when the upper corner is not above the lower one.
    SharpBox(const glm::dvec2& low, const glm::dvec2& high) : bounds_{low, high} {}

    Bounds bounds() const { return bounds_; }

    double coverage(const glm::dvec2& point) const {
        return overlap(bounds_.low.x, bounds_.high.x, point.x) * overlap(bounds_.low.y, bounds_.high.y, point.y);
    }

  private:
    Bounds bounds_;
};

SharpBox box_of(const Rectangle& rectangle) {
    const glm::dvec2 low(rectangle.x, rectangle.y);
    return {low, low + glm::dvec2(rectangle.width, rectangle.height)};
}

class RoundBox {
  public:
    // The radius is at most half of the shorter side.
    RoundBox(const Bounds& bounds, double radius) : bounds_(bounds), radius_(radius) {}

    Bounds bounds() const { return bounds_; }

    double coverage(const glm::dvec2& point) const {
        const glm::dvec2 centre = 0.5 * (bounds_.low + bounds_.high);
        const glm::dvec2 core = 0.5 * (bounds_.high - bounds_.low) - radius_;
        const glm::dvec2 beyond = glm::abs(point - centre) - core;
        const double outside = glm::length(glm::max(beyond, 0.0));
        const double inside = std::min(std::max(beyond.x, beyond.y), 0.0);
        return 0.5 + radius_ - (outside + inside);
    }

  private:
    Bounds bounds_;
    double radius_;
};

class Frame {
  public:
    Frame(const Bounds& outside, double width)
        : outside_(outside.low, outside.high), inside_(outside.low + width, outside.high - width) {}

    Bounds bounds() const { return outside_.bounds(); }

    double coverage(const glm::dvec2& point) const {
        const glm::dvec2 to_edges = glm::min(point - inside_.bounds().low, inside_.bounds().high - point);
        const double depth = std::min(to_edges.x, to_edges.y);
        if (depth >= 0.5) return 0.5 - depth;  // nothing but hole around here
        return outside_.coverage(point) - inside_.coverage(point);
    }

  private:
    SharpBox outside_;
    SharpBox inside_;
};

}  // namespace

Image blank_image(int width, int height, const glm::vec3& colour) {
    if (width < 1 || height < 1) {
        throw RendererError("an image of " + std::to_string(width) + " x " + std::to_string(height) +
                            " pixels is empty");
    }
    Image image{width, height, {}};
    image.rgb.resize(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    std::uint8_t pixel[3]{};
    Ink({.colour = colour}).put(pixel, 1.0f);
    for (std::size_t i = 0; i < image.rgb.size(); ++i) image.rgb[i] = pixel[i % 3];
    return image;
}

void fill(Image& image, const Rectangle& rectangle, const Paint& paint, float corner_radius) {
    const double room = 0.5 * std::min(rectangle.width, rectangle.height);
    if (!finite(rectangle) || !finite(corner_radius) || room <= 0.0) return;
    const SharpBox box = box_of(rectangle);
    if (corner_radius > 0.0f) {
        draw_shape(image, RoundBox(box.bounds(), std::min(static_cast<double>(corner_radius), room)), paint);
    } else {
        draw_shape(image, box, paint);
    }
}

void draw_frame(Image& image, const Rectangle& rectangle, float width, const Paint& paint) {
    if (finite(rectangle) && finite(width) && width > 0.0f)
        draw_shape(image, Frame(box_of(rectangle).bounds(), width), paint);
}

void draw_line(Image& image, glm::vec2 from, glm::vec2 to, float width, const Paint& paint) {
    if (finite(from) && finite(to) && finite(width)) draw_shape(image, Capsule(from, to, width), paint);
}

void draw_arrow(Image& image, glm::vec2 from, glm::vec2 to, float width, const Paint& paint) {
    const bool somewhere = finite(from) && finite(to) && from != to;
    if (somewhere && finite(width)) draw_shape(image, ArrowShape(from, to, width), paint);
}

void draw_dot(Image& image, glm::vec2 centre, float radius, const Paint& paint) {
    if (finite(centre) && finite(radius)) draw_shape(image, Capsule(centre, centre, 2.0 * radius), paint);
}

void paste(Image& onto, const Image& what, int x, int y) {
    // In 64 bits, as the far edge may lie beyond the range of int.
    const auto left = static_cast<std::int64_t>(x);
    const auto top = static_cast<std::int64_t>(y);
    const std::int64_t first_column = std::max<std::int64_t>(-left, 0);
    const std::int64_t end_column = std::min<std::int64_t>(onto.width - left, what.width);
    const std::int64_t first_row = std::max<std::int64_t>(-top, 0);
    const std::int64_t end_row = std::min<std::int64_t>(onto.height - top, what.height);
    if (first_column >= end_column) return;
    for (std::int64_t row = first_row; row < end_row; ++row) {
        const auto from = what.rgb.begin() + 3 * (row * what.width + first_column);
        std::copy(from, from + 3 * (end_column - first_column),
                  onto.rgb.begin() + 3 * ((top + row) * onto.width + left + first_column));
    }
}

}  // namespace pushfactor::renderer
