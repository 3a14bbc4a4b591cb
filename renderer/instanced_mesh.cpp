#include "renderer/instanced_mesh.h"

#include <cstddef>

namespace pushfactor::renderer {
namespace {

template <typename Range>
void upload(const Gl& gl, GLenum target, const GlObject& buffer, const Range& elements, GLenum usage) {
    gl.BindBuffer(target, buffer.name());
    gl.BufferData(target, static_cast<GLsizeiptr>(std::span(elements).size_bytes()), elements.data(), usage);
}

// Describes a member of the bound buffer's elements. It advances for each vertex with `divisor` 0, for each
// instance with 1.
void attribute(const Gl& gl, GLuint location, GLint components, std::size_t stride, std::size_t offset,
               GLuint divisor) {
    gl.EnableVertexAttribArray(location);
    gl.VertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                           reinterpret_cast<const void*>(offset));
    gl.VertexAttribDivisor(location, divisor);
}

}  // namespace

InstancedMesh::InstancedMesh(const Gl& gl, const Mesh& mesh)
    : gl_(gl),
      attributes_(gl.GenVertexArrays, gl.DeleteVertexArrays),
      vertices_(gl.GenBuffers, gl.DeleteBuffers),
      indices_(gl.GenBuffers, gl.DeleteBuffers),
      instances_(gl.GenBuffers, gl.DeleteBuffers),
      index_count_(static_cast<GLsizei>(mesh.indices.size())) {
    gl.BindVertexArray(attributes_.name());
    upload(gl, GL_ELEMENT_ARRAY_BUFFER, indices_, mesh.indices, GL_STATIC_DRAW);

    upload(gl, GL_ARRAY_BUFFER, vertices_, mesh.vertices, GL_STATIC_DRAW);
    attribute(gl, 0, 3, sizeof(Vertex), offsetof(Vertex, corner), 0);
    attribute(gl, 1, 3, sizeof(Vertex), offsetof(Vertex, normal), 0);

    gl.BindBuffer(GL_ARRAY_BUFFER, instances_.name());
    attribute(gl, 2, 3, sizeof(Instance), offsetof(Instance, position), 1);
    attribute(gl, 3, 1, sizeof(Instance), offsetof(Instance, bevel), 1);
    attribute(gl, 4, 4, sizeof(Instance), offsetof(Instance, orientation), 1);
    attribute(gl, 5, 3, sizeof(Instance), offsetof(Instance, half_extents), 1);
    attribute(gl, 6, 3, sizeof(Instance), offsetof(Instance, colour), 1);
}

void InstancedMesh::set_instances(std::span<const Instance> instances) {
    upload(gl_, GL_ARRAY_BUFFER, instances_, instances, GL_STREAM_DRAW);
    instance_count_ = static_cast<GLsizei>(instances.size());
}

void InstancedMesh::draw() const {
    gl_.BindVertexArray(attributes_.name());
    gl_.DrawElementsInstanced(GL_TRIANGLES, index_count_, GL_UNSIGNED_SHORT, nullptr, instance_count_);
}

}  // namespace pushfactor::renderer
