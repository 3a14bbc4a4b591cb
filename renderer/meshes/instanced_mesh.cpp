#include "renderer/meshes/instanced_mesh.h"

#include "renderer/gl/vertex_data.h"

#include <algorithm>
#include <cstddef>

namespace pushfactor::renderer {
namespace {

// A software rasteriser keeps what it has been given until it draws it. Many bodies are drawn by parts of so many
// triangles, of which it holds one at a time: 129 MB instead of 211 for a still of 2000 spheres.
constexpr GLsizei most_triangles = 20000;

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
    describe_attribute(gl, 0, 3, sizeof(Vertex), offsetof(Vertex, corner), 0);
    describe_attribute(gl, 1, 3, sizeof(Vertex), offsetof(Vertex, normal), 0);
}

void InstancedMesh::set_instances(std::span<const Instance> instances) {
    upload(gl_, GL_ARRAY_BUFFER, instances_, instances, GL_STREAM_DRAW);
    instance_count_ = static_cast<GLsizei>(instances.size());
}

void InstancedMesh::draw() const {
    gl_.BindVertexArray(attributes_.name());
    gl_.BindBuffer(GL_ARRAY_BUFFER, instances_.name());
    const GLsizei most = std::max(3 * most_triangles / index_count_, 1);
    for (GLsizei first = 0; first < instance_count_; first += most) {
        if (first > 0) gl_.Finish();
        begin_with(first);
        const GLsizei count = std::min(instance_count_ - first, most);
        gl_.DrawElementsInstanced(GL_TRIANGLES, index_count_, GL_UNSIGNED_SHORT, nullptr, count);
    }
}

// What is drawn next has this instance as its first.
void InstancedMesh::begin_with(GLsizei instance) const {
    const auto member = [&](GLuint location, GLint components, std::size_t offset) {
        const std::size_t start = static_cast<std::size_t>(instance) * sizeof(Instance);
        describe_attribute(gl_, location, components, sizeof(Instance), start + offset, 1);
    };
    member(2, 3, offsetof(Instance, position));
    member(3, 1, offsetof(Instance, bevel));
    member(4, 4, offsetof(Instance, orientation));
    member(5, 3, offsetof(Instance, half_extents));
    member(6, 3, offsetof(Instance, colour));
    member(7, 1, offsetof(Instance, number));
}

}  // namespace pushfactor::renderer
