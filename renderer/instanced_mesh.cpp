#include "renderer/instanced_mesh.h"

#include "renderer/vertex_data.h"

#include <cstddef>

namespace pushfactor::renderer {

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
    describe_attribute(gl, 0, 3, sizeof(Vertex), offsetof(Vertex, corner), 0);
    describe_attribute(gl, 1, 3, sizeof(Vertex), offsetof(Vertex, normal), 0);

    gl.BindBuffer(GL_ARRAY_BUFFER, instances_.name());
    describe_attribute(gl, 2, 3, sizeof(Instance), offsetof(Instance, position), 1);
    describe_attribute(gl, 3, 1, sizeof(Instance), offsetof(Instance, bevel), 1);
    describe_attribute(gl, 4, 4, sizeof(Instance), offsetof(Instance, orientation), 1);
    describe_attribute(gl, 5, 3, sizeof(Instance), offsetof(Instance, half_extents), 1);
    describe_attribute(gl, 6, 3, sizeof(Instance), offsetof(Instance, colour), 1);
    describe_attribute(gl, 7, 1, sizeof(Instance), offsetof(Instance, number), 1);
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
