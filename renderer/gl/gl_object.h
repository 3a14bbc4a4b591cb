#pragma once

#include "renderer/gl/gl.h"

namespace pushfactor::renderer {

// RAII owner of a buffer, texture, renderbuffer, framebuffer or vertex array: `GlObject texture(gl.GenTextures,
// gl.DeleteTextures)`. Its context must be current in constructor and destructor.
class GlObject {
  public:
    // All of these kinds have the signatures of buffers.
    GlObject(decltype(Gl::GenBuffers) generate, decltype(Gl::DeleteBuffers) remove) : remove_(remove) {
        generate(1, &name_);
    }
    ~GlObject() { remove_(1, &name_); }
    GlObject(const GlObject&) = delete;
    GlObject& operator=(const GlObject&) = delete;

    GLuint name() const { return name_; }

  private:
    decltype(Gl::DeleteBuffers) remove_;
    GLuint name_ = 0;
};

}  // namespace pushfactor::renderer
