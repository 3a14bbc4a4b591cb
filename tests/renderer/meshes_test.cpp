#include "renderer/meshes/meshes.h"

#include "tests/catch.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <cstddef>
#include <map>
#include <utility>

using namespace pushfactor::renderer;

namespace {

glm::vec3 point(const Vertex& vertex, const glm::vec3& half_extents, float bevel) {
    return vertex.corner * (half_extents - bevel) + vertex.normal * bevel;
}

// Volume of a closed mesh, by the divergence theorem; negative when the triangles face inwards.
float volume(const Mesh& mesh, const glm::vec3& half_extents, float bevel) {
    float sum = 0.0f;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::vec3 a = point(mesh.vertices[mesh.indices[i]], half_extents, bevel);
        const glm::vec3 b = point(mesh.vertices[mesh.indices[i + 1]], half_extents, bevel);
        const glm::vec3 c = point(mesh.vertices[mesh.indices[i + 2]], half_extents, bevel);
        sum += glm::dot(a, glm::cross(b, c)) / 6.0f;
    }
    return sum;
}

}  // namespace

TEST_CASE("The box is closed: each edge is used once in each direction") {
    const Mesh mesh = box_mesh();
    std::map<std::pair<int, int>, int> uses;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k) ++uses[{mesh.indices[i + k], mesh.indices[i + (k + 1) % 3]}];
    }
    CHECK(mesh.indices.size() == 3 * 44);
    for (const auto& [edge, count] : uses) {
        CHECK(count == 1);
        CHECK(uses.contains({edge.second, edge.first}));
    }
}

TEST_CASE("The box fills its extents, and a bevel takes from its edges only") {
    const glm::vec3 half_extents(1.0f, 2.0f, 3.0f);
    CHECK(volume(box_mesh(), half_extents, 0.0f) == Approx(48.0f));

    // A chamfer of leg b along 4 (4 + 2 + 6 - 6 b) m of edges takes b^2 / 2 of their length, and at each of
    // the eight corners 5/6 b^3.
    const float b = 0.1f;
    const float taken = 8.0f * (6.0f - 3.0f * b) * b * b / 2.0f + 8.0f * 5.0f / 6.0f * b * b * b;
    CHECK(volume(box_mesh(), half_extents, b) == Approx(48.0f - taken));
}

TEST_CASE("A dome is half of a sphere that faces outwards") {
    const Mesh mesh = dome_mesh(96, 12);
    for (const Vertex& vertex : mesh.vertices) {
        CHECK(glm::length(vertex.normal) == Approx(1.0f));
        CHECK(vertex.normal.z >= 0.0f);
    }
    // The bottom that is missing lies in a plane through the origin and would add nothing.
    CHECK(volume(mesh, glm::vec3(2.0f), 2.0f) == Approx(16.0f / 3.0f * glm::pi<float>()).epsilon(0.01));
}

TEST_CASE("The square faces up") {
    const Mesh mesh = square_mesh();
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::vec3 a = mesh.vertices[mesh.indices[i]].corner;
        const glm::vec3 b = mesh.vertices[mesh.indices[i + 1]].corner;
        const glm::vec3 c = mesh.vertices[mesh.indices[i + 2]].corner;
        CHECK(glm::cross(b - a, c - a).y > 0.0f);
    }
}
