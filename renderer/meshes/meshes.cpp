#include "renderer/meshes/meshes.h"

#include <glm/geometric.hpp>

#include <array>
#include <cstddef>

namespace pushfactor::renderer {
namespace {

// A corner of the box by its bits: bit a is set where the coordinate along axis a is positive.
glm::vec3 corner_position(int corner) {
    return {(corner & 1) != 0 ? 1.0f : -1.0f, (corner & 2) != 0 ? 1.0f : -1.0f, (corner & 4) != 0 ? 1.0f : -1.0f};
}

// Each corner has one vertex for each of the three faces that meet there.
int vertex_at(int corner, int face_axis) {
    return 3 * corner + face_axis;
}

void add_triangle(Mesh& mesh, const std::array<int, 3>& triangle) {
    std::array<Vertex, 3> vertices;
    for (std::size_t i = 0; i < 3; ++i) vertices[i] = mesh.vertices[static_cast<std::size_t>(triangle[i])];

    // With any bevel the points tell the winding; a bevel of 1/2 stands for all.
    const auto point = [](const Vertex& vertex) { return 0.5f * (vertex.corner + vertex.normal); };
    const glm::vec3 normal =
        glm::cross(point(vertices[1]) - point(vertices[0]), point(vertices[2]) - point(vertices[0]));
    const glm::vec3 outwards = vertices[0].normal + vertices[1].normal + vertices[2].normal;
    const bool inside_out = glm::dot(normal, outwards) < 0.0f;

    for (std::size_t i = 0; i < 3; ++i) {
        mesh.indices.push_back(static_cast<std::uint16_t>(triangle[inside_out ? 2 - i : i]));
    }
}

// The points are given around the quad, in either direction.
void add_quad(Mesh& mesh, const std::array<int, 4>& quad) {
    add_triangle(mesh, {quad[0], quad[1], quad[2]});
    add_triangle(mesh, {quad[0], quad[2], quad[3]});
}

}  // namespace

Mesh box_mesh() {
    Mesh mesh;
    for (int corner = 0; corner < 8; ++corner) {
        for (int axis = 0; axis < 3; ++axis) {
            const glm::vec3 position = corner_position(corner);
            glm::vec3 normal(0.0f);
            normal[axis] = position[axis];
            mesh.vertices.push_back({position, normal});
        }
    }
    for (int corner = 0; corner < 8; ++corner) {
        add_triangle(mesh, {vertex_at(corner, 0), vertex_at(corner, 1), vertex_at(corner, 2)});
    }
    for (int axis = 0; axis < 3; ++axis) {
        const int next_axis = (axis + 1) % 3;
        const int last_axis = (axis + 2) % 3;
        const int along = 1 << axis;
        const int next = 1 << next_axis;
        const int last = 1 << last_axis;
        for (const int face : {0, along}) {
            add_quad(mesh, {vertex_at(face, axis), vertex_at(face | next, axis),
                            vertex_at(face | next | last, axis), vertex_at(face | last, axis)});
        }
        for (const int edge : {0, next, last, next | last}) {
            add_quad(mesh, {vertex_at(edge, next_axis), vertex_at(edge | along, next_axis),
                            vertex_at(edge | along, last_axis), vertex_at(edge, last_axis)});
        }
    }
    return mesh;
}

Mesh square_mesh() {
    const glm::vec3 up(0.0f, 1.0f, 0.0f);
    Mesh mesh;
    mesh.vertices = {
        {{-1.0f, 0.0f, -1.0f}, up}, {{1.0f, 0.0f, -1.0f}, up}, {{1.0f, 0.0f, 1.0f}, up}, {{-1.0f, 0.0f, 1.0f}, up}};
    add_quad(mesh, {0, 1, 2, 3});
    return mesh;
}

}  // namespace pushfactor::renderer
