#pragma once

#include "renderer/gl/gl.h"
#include "renderer/images/image.h"
#include "renderer/picture/picture.h"

#include <glm/vec3.hpp>

namespace pushfactor::renderer {

// Throws RendererError that names the errors that OpenGL has recorded since it was asked last, if any.
void check_gl_errors(const Gl& gl);

// Throws RendererError when the framebuffer bound for drawing cannot be drawn into; it says why and names
// `purpose`.
void check_framebuffer(const Gl& gl, const char* purpose);

// Throws RendererError when nothing but the background, a colour in linear light, is in the image that this
// camera took.
void check_in_view(const Image& image, const glm::vec3& background, const Camera& camera);

}  // namespace pushfactor::renderer
