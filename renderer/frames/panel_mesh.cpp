#include "renderer/frames/panel_mesh.h"

#include "renderer/gl/vertex_data.h"

#include <cstddef>

namespace pushfactor::renderer {

PanelMesh::PanelMesh(const Gl& gl)
    : gl_(gl), attributes_(gl.GenVertexArrays, gl.DeleteVertexArrays), vertices_(gl.GenBuffers, gl.DeleteBuffers) {
    gl.BindVertexArray(attributes_.name());
    gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    describe_attribute(gl, 0, 3, sizeof(PanelVertex), offsetof(PanelVertex, position), 0);
    describe_attribute(gl, 1, 3, sizeof(PanelVertex), offsetof(PanelVertex, normal), 0);
    describe_attribute(gl, 2, 3, sizeof(PanelVertex), offsetof(PanelVertex, colour), 0);
    describe_attribute(gl, 3, 1, sizeof(PanelVertex), offsetof(PanelVertex, opacity), 0);
    describe_attribute(gl, 4, 1, sizeof(PanelVertex), offsetof(PanelVertex, from_edge), 0);
    describe_attribute(gl, 5, 2, sizeof(PanelVertex), offsetof(PanelVertex, in_plane), 0);
}

void PanelMesh::set_triangles(std::span<const PanelVertex> vertices) {
    upload(gl_, GL_ARRAY_BUFFER, vertices_, vertices, GL_STREAM_DRAW);
    vertex_count_ = static_cast<GLsizei>(vertices.size());
}

void PanelMesh::draw() const {
    gl_.BindVertexArray(attributes_.name());
    gl_.DrawArrays(GL_TRIANGLES, 0, vertex_count_);
}

}  // namespace pushfactor::renderer
