#pragma once

#include "renderer/images/image.h"
#include "renderer/picture/picture.h"

namespace pushfactor::renderer {

// Draws the dots and arrows of a picture that passes check() over the image that has been made of the rest of it.
// Their widths follow the image's height.
void draw_marks(Image& image, const Picture& picture);

}  // namespace pushfactor::renderer
