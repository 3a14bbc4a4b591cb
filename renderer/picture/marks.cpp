#include "renderer/picture/marks.h"

#include "renderer/images/paint.h"
#include "renderer/images/shapes.h"
#include "renderer/picture/views.h"

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include <algorithm>
#include <initializer_list>
#include <optional>

namespace pushfactor::renderer {
namespace {

// Shorter arrows on the screen are omitted, px: their direction would not be visible.
constexpr double least_length = 2.0;

// A light outline around marks, for dark backgrounds.
const Paint casing{.colour = glm::vec3(1.0f), .opacity = 0.85f};

// Visible part of a segment, in clip space.
struct Segment {
    glm::dvec4 from;
    glm::dvec4 to;
    bool to_is_its_end;
};

// Point on the line from `from` to `to` at which a value changes its sign.
glm::dvec4 between(const glm::dvec4& from, const glm::dvec4& to, double value_from, double value_to) {
    return from + (value_from / (value_from - value_to)) * (to - from);
}

// Clips what is in front of the near plane or behind the eye, or so far outside of the image that pixel coordinates
// become too large.
std::optional<Segment> visible_part(Segment segment) {
    constexpr double reach = 16.0;  // half sides of the image
    for (const glm::dvec4& plane :
         {glm::dvec4(0.0, 0.0, 1.0, 1.0), glm::dvec4(1.0, 0.0, 0.0, reach), glm::dvec4(-1.0, 0.0, 0.0, reach),
          glm::dvec4(0.0, 1.0, 0.0, reach), glm::dvec4(0.0, -1.0, 0.0, reach)}) {
        const double from = glm::dot(plane, segment.from);
        const double to = glm::dot(plane, segment.to);
        if (from <= 0.0 && to <= 0.0) return std::nullopt;
        if (from < 0.0) segment.from = between(segment.from, segment.to, from, to);
        if (to < 0.0) {
            segment.to = between(segment.from, segment.to, from, to);
            segment.to_is_its_end = false;
        }
    }
    // For points too far away for the floating-point precision a cut may be anywhere.
    if (segment.from.w <= 0.0 || segment.to.w <= 0.0) return std::nullopt;
    return segment;
}

class Marks {
  public:
    Marks(Image& image, const Picture& picture)
        : image_(image),
          size_(image.width, image.height),
          unit_(size_.y * static_cast<double>(picture.mark_scale)),
          world_to_clip_(projection(picture.camera, size_)) {}

    void draw(const Dot& dot) {
        const glm::dvec4 position = clip_position(dot.position);
        if (position.z <= -position.w || position.w <= 0.0) return;
        const glm::dvec2 centre = on_image(position);
        const double width = 2.0 * std::max(2.0, unit_ / 160.0);
        draw_shape(image_, Capsule(centre, centre, width + 2.0 * casing_width()), casing);
        draw_shape(image_, Capsule(centre, centre, width), {.colour = dot.colour});
    }

    void draw(const Arrow& arrow) {
        const auto seen = visible_part({clip_position(arrow.from), clip_position(arrow.to), true});
        if (!seen) return;
        const glm::dvec2 from = on_image(seen->from);
        const glm::dvec2 to = on_image(seen->to);
        if (glm::distance(from, to) < least_length) return;
        const double width = std::max(1.5, unit_ / 220.0);
        if (!arrow.head && !arrow.outlined) {
            draw_shape(image_, Capsule(from, to, width), {.colour = arrow.colour});
        } else if (arrow.head && seen->to_is_its_end) {
            draw_shape(image_, ArrowShape(from, to, width, casing_width()), casing);
            draw_shape(image_, ArrowShape(from, to, width), {.colour = arrow.colour});
        } else {
            draw_shape(image_, Capsule(from, to, width + 2.0 * casing_width()), casing);
            draw_shape(image_, Capsule(from, to, width), {.colour = arrow.colour});
        }
    }

  private:
    // The far plane does not affect the position of a point in the image.
    static glm::dmat4 projection(const Camera& camera, const glm::dvec2& size) {
        return camera_view(camera, static_cast<float>(size.x / size.y), 100.0f * scale_of(camera));
    }

    glm::dvec4 clip_position(const glm::vec3& point) const {
        return world_to_clip_ * glm::dvec4(glm::dvec3(point), 1.0);
    }

    // px
    glm::dvec2 on_image(const glm::dvec4& position) const {
        return size_ * (0.5 + 0.5 * glm::dvec2(position.x, -position.y) / position.w);
    }

    double casing_width() const { return std::max(0.7, unit_ / 720.0); }  // on each side, px

    Image& image_;
    glm::dvec2 size_;  // px
    double unit_;      // px, reference for widths
    glm::dmat4 world_to_clip_;
};

}  // namespace

void draw_marks(Image& image, const Picture& picture) {
    Marks marks(image, picture);
    for (const Dot& dot : picture.dots) marks.draw(dot);
    for (const Arrow& arrow : picture.arrows) marks.draw(arrow);
}

}  // namespace pushfactor::renderer
