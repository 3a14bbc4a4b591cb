#pragma once

#include "renderer/gl/gl.h"
#include "renderer/images/image.h"
#include "renderer/picture/picture.h"

#include <glm/vec3.hpp>

namespace pushfactor::renderer {

// Throws RendererError with the names of the OpenGL errors recorded since the last call, if any.
void check_gl_errors(const Gl& gl);

// Throws RendererError with the reason and `purpose` if the framebuffer bound for drawing is incomplete.
void check_framebuffer(const Gl& gl, const char* purpose);

// Whether the image shows nothing but the background, sRGB.
bool shows_only(const glm::vec3& background, const Image& image);

}  // namespace pushfactor::renderer
