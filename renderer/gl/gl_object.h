#pragma once

#include "renderer/gl/gl.h"

namespace pushfactor::renderer {

// A buffer, texture, renderbuffer, framebuffer or vertex array that is deleted with its owner:
// `GlObject texture(gl.GenTextures, gl.DeleteTextures)`. Its context must be current at both ends.
class GlObject {
  public:
    // All of these kinds share the signatures of the buffers.
    GlObject(decltype(&glGenBuffers) generate, decltype(&glDeleteBuffers) remove) : remove_(remove) {
        generate(1, &name_);
    }
    ~GlObject() { remove_(1, &name_); }
    GlObject(const GlObject&) = delete;
    GlObject& operator=(const GlObject&) = delete;

    GLuint name() const { return name_; }

  private:
    decltype(&glDeleteBuffers) remove_;
    GLuint name_ = 0;
};

}  // namespace pushfactor::renderer
