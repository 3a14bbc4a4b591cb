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

// Throws RendererError if the image taken by this camera shows only the background, sRGB.
void check_in_view(const Image& image, const glm::vec3& background, const Camera& camera);

}  // namespace pushfactor::renderer
