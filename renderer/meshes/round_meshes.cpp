#include "renderer/meshes/meshes.h"

#include <glm/trigonometric.hpp>

#include <cmath>
#include <numbers>

namespace pushfactor::renderer {
namespace {

// The angle of a vertex on a ring, radians.
float angle(int side, int sides) {
    return 2.0f * std::numbers::pi_v<float> * static_cast<float>(side) / static_cast<float>(sides);
}

void add_triangle(Mesh& mesh, int a, int b, int c) {
    for (const int vertex : {a, b, c}) mesh.indices.push_back(static_cast<std::uint16_t>(vertex));
}

}  // namespace

Mesh dome_mesh(int sides, int rings) {
    Mesh mesh;
    for (int ring = 0; ring < rings; ++ring) {
        const float latitude =
            0.5f * std::numbers::pi_v<float> * static_cast<float>(ring) / static_cast<float>(rings);
        for (int side = 0; side < sides; ++side) {
            const float longitude = angle(side, sides);
            mesh.vertices.push_back(
                {glm::vec3(0.0f), glm::vec3(std::cos(latitude) * std::cos(longitude),
                                            std::cos(latitude) * std::sin(longitude), std::sin(latitude))});
        }
    }
    const int top = sides * rings;
    mesh.vertices.push_back({glm::vec3(0.0f), glm::vec3(0.0f, 0.0f, 1.0f)});
    for (int ring = 0; ring < rings; ++ring) {
        for (int side = 0; side < sides; ++side) {
            const int low = ring * sides + side;
            const int low_next = ring * sides + (side + 1) % sides;
            if (ring + 1 == rings) {
                add_triangle(mesh, low, low_next, top);
            } else {
                add_triangle(mesh, low, low_next, low + sides);
                add_triangle(mesh, low_next, low_next + sides, low + sides);
            }
        }
    }
    return mesh;
}

}  // namespace pushfactor::renderer
