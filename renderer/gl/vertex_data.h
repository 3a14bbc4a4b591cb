#pragma once

#include "renderer/gl/gl.h"
#include "renderer/gl/gl_object.h"

#include <cstddef>
#include <span>

namespace pushfactor::renderer {

// Replaces what a buffer holds, and leaves it bound to `target`.
template <typename Range>
void upload(const Gl& gl, GLenum target, const GlObject& buffer, const Range& elements, GLenum usage) {
    gl.BindBuffer(target, buffer.name());
    gl.BufferData(target, static_cast<GLsizeiptr>(std::span(elements).size_bytes()), elements.data(), usage);
}

// Tells the bound vertex array of a member of the bound buffer's elements: `components` floats, `offset` bytes
// from the start of each element of `stride` bytes. It advances for each vertex with `divisor` 0, for each
// instance with 1.
void describe_attribute(const Gl& gl, GLuint location, GLint components, std::size_t stride, std::size_t offset,
                        GLuint divisor);

}  // namespace pushfactor::renderer
