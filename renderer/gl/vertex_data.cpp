#include "renderer/gl/vertex_data.h"

namespace pushfactor::renderer {

void describe_attribute(const Gl& gl, GLuint location, GLint components, std::size_t stride, std::size_t offset,
                        GLuint divisor) {
    gl.EnableVertexAttribArray(location);
    gl.VertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                           reinterpret_cast<const void*>(offset));
    gl.VertexAttribDivisor(location, divisor);
}

}  // namespace pushfactor::renderer
