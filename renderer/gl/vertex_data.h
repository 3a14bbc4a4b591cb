#pragma once

#include "renderer/gl/gl.h"
#include "renderer/gl/gl_object.h"

#include <cstddef>
#include <span>

namespace pushfactor::renderer {

// Replaces the contents of a buffer, and leaves it bound to `target`.
template <typename Range>
void upload(const Gl& gl, GLenum target, const GlObject& buffer, const Range& elements, GLenum usage) {
    gl.BindBuffer(target, buffer.name());
    gl.BufferData(target, static_cast<GLsizeiptr>(std::span(elements).size_bytes()), elements.data(), usage);
}

// Describes a member of the bound buffer's elements to the bound vertex array: `components` floats at `offset`
// bytes in elements of `stride` bytes. Advances per vertex with `divisor` 0, per instance with 1.
void describe_attribute(const Gl& gl, GLuint location, GLint components, std::size_t stride, std::size_t offset,
                        GLuint divisor);

}  // namespace pushfactor::renderer
