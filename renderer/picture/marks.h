#pragma once

#include "renderer/images/image.h"
#include "renderer/picture/picture.h"

namespace pushfactor::renderer {

// Draws the dots and arrows of a valid picture (see check()) over the image of the rest. Their widths are
// proportional to the image's height.
void draw_marks(Image& image, const Picture& picture);

}  // namespace pushfactor::renderer
