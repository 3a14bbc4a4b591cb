#include "renderer/images/shapes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>

namespace pushfactor::renderer {
namespace {

constexpr double head_breadth = 3.2;  // of an arrow's head, in widths of its shaft
constexpr double head_length = 3.6;

double distance_to_segment(const glm::dvec2& point, const glm::dvec2& from, const glm::dvec2& to) {
    const glm::dvec2 along = to - from;
    const glm::dvec2 reached = point - from;
    const double projection = glm::dot(reached, along);
    if (projection <= 0.0) return glm::length(reached);
    if (projection >= glm::dot(along, along)) return glm::distance(point, to);
    // Not through the foot of the perpendicular: when the ends are far away that is known poorly.
    return std::abs(reached.x * along.y - reached.y * along.x) / glm::length(along);
}

// To a triangle with its tip in (0, 0) and the ends of its base in (length, +-half_breadth); negative inside.
double distance_to_head(glm::dvec2 point, double length, double half_breadth) {
    point.y = std::abs(point.y);
    const glm::dvec2 corner(length, half_breadth);
    const double distance =
        std::min(distance_to_segment(point, {0.0, 0.0}, corner), distance_to_segment(point, corner, {length, 0.0}));
    const bool inside = point.x <= length && point.y * length <= point.x * half_breadth;
    return inside ? -distance : distance;
}

}  // namespace

Capsule::Capsule(const glm::dvec2& from, const glm::dvec2& to, double width)
    : from_(from), to_(to), width_(width) {}

Bounds Capsule::bounds() const {
    return {glm::min(from_, to_) - 0.5 * width_, glm::max(from_, to_) + 0.5 * width_};
}

double Capsule::coverage(const glm::dvec2& point) const {
    // A line narrower than a pixel covers no pixel whole.
    return std::min(0.5 + 0.5 * width_ - distance_to_segment(point, from_, to_), width_);
}

ArrowShape::ArrowShape(const glm::dvec2& from, const glm::dvec2& to, double width, double grown)
    : ArrowShape(from, to, std::min(width, glm::distance(from, to) / (2.0 * head_length)), grown,
                 glm::distance(from, to)) {}

// Here `width` is that of the shaft as it is drawn. The shaft ends inside of the head, round end and all.
ArrowShape::ArrowShape(const glm::dvec2& from, const glm::dvec2& to, double width, double grown, double length)
    : shaft_(from, to + (from - to) * (0.5 * head_length * width / length), width + 2.0 * grown),
      tip_(to),
      backwards_((from - to) / length),
      head_length_(head_length * width),
      head_half_breadth_(0.5 * head_breadth * width),
      grown_(grown) {}

Bounds ArrowShape::bounds() const {
    const Bounds shaft = shaft_.bounds();
    const double reach = glm::length(glm::dvec2(head_length_, head_half_breadth_)) + grown_;
    return {glm::min(shaft.low, tip_ - reach), glm::max(shaft.high, tip_ + reach)};
}

double ArrowShape::coverage(const glm::dvec2& point) const {
    const glm::dvec2 from_tip = point - tip_;
    const glm::dvec2 in_head(glm::dot(from_tip, backwards_), from_tip.x * backwards_.y - from_tip.y * backwards_.x);
    const double of_head = 0.5 + grown_ - distance_to_head(in_head, head_length_, head_half_breadth_);
    // As with a line: a head narrower than a pixel covers none whole.
    const double most = 2.0 * (head_half_breadth_ + grown_);
    return std::max(std::min(of_head, most), shaft_.coverage(point));
}

PixelRange pixels_within(const Bounds& bounds, const Image& image) {
    const auto cut = [](double position, int side) {
        return static_cast<int>(std::clamp(position, 0.0, static_cast<double>(side)));
    };
    return {cut(std::floor(bounds.low.x), image.width), cut(std::ceil(bounds.high.x), image.width),
            cut(std::floor(bounds.low.y), image.height), cut(std::ceil(bounds.high.y), image.height)};
}

}  // namespace pushfactor::renderer
