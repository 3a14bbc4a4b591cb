#pragma once

#include "renderer/images/image.h"
#include "renderer/images/paint.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace pushfactor::renderer {

// Flat drawing onto images, with smooth edges. Coordinates and lengths are pixels, x to the right and y down from
// the image's upper left corner: pixel (i, j) is the square from (i, j) to (i + 1, j + 1). What lies outside of the
// image is cut off. What has no size, or a number that is not finite, draws nothing.

struct Rectangle {
    float x = 0.0f;       // of the left edge
    float y = 0.0f;       // of the upper edge
    float width = 0.0f;   // > 0
    float height = 0.0f;  // > 0
};

// An image of one colour (sRGB, each 0..1). Throws RendererError when a side is not at least 1 pixel.
Image blank_image(int width, int height, const glm::vec3& colour);

// Corners are rounded by `corner_radius`, as far as the rectangle has room for that.
void fill(Image& image, const Rectangle& rectangle, const Paint& paint, float corner_radius = 0.0f);

// The outline of a rectangle: `width` pixels along its edges, on the inside.
void draw_frame(Image& image, const Rectangle& rectangle, float width, const Paint& paint);

// A line with round ends, which reach half its width beyond the two points.
void draw_line(Image& image, glm::vec2 from, glm::vec2 to, float width, const Paint& paint);

// A line of that width with a filled head, whose tip is at `to`: 3.2 widths broad and 3.6 long. Where that is more
// than half of the arrow, all of it is drawn smaller.
void draw_arrow(Image& image, glm::vec2 from, glm::vec2 to, float width, const Paint& paint);

// A filled disc.
void draw_dot(Image& image, glm::vec2 centre, float radius, const Paint& paint);

// Copies another image so that its upper left pixel comes to lie at (x, y), which may be outside.
void paste(Image& onto, const Image& what, int x, int y);

}  // namespace pushfactor::renderer
