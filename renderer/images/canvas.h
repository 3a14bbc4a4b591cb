#pragma once

#include "renderer/images/image.h"
#include "renderer/images/paint.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace pushfactor::renderer {

// Anti-aliased 2D drawing onto images. Coordinates and lengths in pixels, x to the right and y down from the
// image's upper left corner: pixel (i, j) is the square from (i, j) to (i + 1, j + 1). Clipped to the image. Shapes
// without size or with non-finite numbers draw nothing.

struct Rectangle {
    float x = 0.0f;       // left edge
    float y = 0.0f;       // upper edge
    float width = 0.0f;   // > 0
    float height = 0.0f;  // > 0
};

// An image of one colour (sRGB, each 0..1). Throws RendererError if a side is below 1 pixel.
Image blank_image(int width, int height, const glm::vec3& colour);

// Corners are rounded with `corner_radius`, limited by the size of the rectangle.
void fill(Image& image, const Rectangle& rectangle, const Paint& paint, float corner_radius = 0.0f);

// Outline of a rectangle: `width` pixels along its edges, inside.
void draw_frame(Image& image, const Rectangle& rectangle, float width, const Paint& paint);

// A line with round ends that extend half its width beyond the two points.
void draw_line(Image& image, glm::vec2 from, glm::vec2 to, float width, const Paint& paint);

// A line of that width with a filled head whose tip is at `to`, 3.2 widths broad and 3.6 long. If that is more than
// half of the arrow, the whole arrow is drawn smaller.
void draw_arrow(Image& image, glm::vec2 from, glm::vec2 to, float width, const Paint& paint);

// A filled disc.
void draw_dot(Image& image, glm::vec2 centre, float radius, const Paint& paint);

// Copies another image with its upper left pixel at (x, y), which may be outside.
void paste(Image& onto, const Image& what, int x, int y);

}  // namespace pushfactor::renderer
