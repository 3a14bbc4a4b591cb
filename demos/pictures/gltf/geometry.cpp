#include "demos/pictures/gltf/geometry.h"

#include "demos/pictures/draw_list.h"
#include "renderer/meshes/meshes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pushfactor::demos::pictures::gltf {

namespace {

using Triangles = std::vector<std::uint16_t>;

// The mesh as the shaders place it (renderer/meshes/meshes.h).
Geometry placed(const renderer::Mesh& mesh, const glm::vec3& half, float bevel) {
    Geometry geometry;
    for (const renderer::Vertex& vertex : mesh.vertices) {
        geometry.positions.push_back(vertex.corner * (half - bevel) + vertex.normal * bevel);
        geometry.normals.push_back(vertex.normal);
    }
    geometry.parts.push_back(mesh.indices);
    return geometry;
}

// A ring of corners at height y whose normals have these parts outwards and upwards, and the triangles that it
// closes: a wall to the ring before, which is below, or a lid, seen from above or from below.
struct Ring {
    float radius, y, outwards, upwards;
    enum { none, wall, above, below } closes = none;
};

// A surface of revolution about the y axis. Rings share neither corners nor normals where the profile has an edge.
Geometry turned(std::initializer_list<Ring> rings) {
    constexpr int sides = 16;
    Geometry made;
    Triangles triangles;
    const auto triangle = [&](int a, int b, int c) {
        for (const int corner : {a, b, c}) triangles.push_back(static_cast<std::uint16_t>(corner));
    };
    for (const auto& [radius, y, outwards, upwards, closes] : rings) {
        const int first = static_cast<int>(made.positions.size());
        for (int side = 0; side < sides; ++side) {
            const double angle = 2.0 * std::numbers::pi * side / sides;
            const auto x = static_cast<float>(std::sin(angle)), z = static_cast<float>(std::cos(angle));
            made.positions.push_back({radius * x, y, radius * z});
            made.normals.push_back({outwards * x, upwards, outwards * z});
        }
        for (int side = 0; closes == Ring::wall && side < sides; ++side) {
            const int next = (side + 1) % sides;
            triangle(first - sides + side, first - sides + next, first + next);
            triangle(first - sides + side, first + next, first + side);
        }
        for (int side = 1; (closes == Ring::above || closes == Ring::below) && side + 1 < sides; ++side) {
            const int turn = closes == Ring::above ? 0 : 1;
            triangle(first, first + side + turn, first + side + 1 - turn);
        }
    }
    made.parts = {triangles};
    return made;
}

}  // namespace

Geometry box(const glm::vec3& half_extents) {
    constexpr float bevel = 0.08f;  // of the smallest half extent, as in renderer/picture/instances.cpp
    return placed(renderer::box_mesh(), half_extents,
                  bevel * std::min({half_extents.x, half_extents.y, half_extents.z}));
}

Geometry ball() {
    const renderer::Mesh dome = renderer::dome_mesh(32, 8);  // a multiple of four sides: octants end on edges
    Geometry geometry = placed(dome, glm::vec3(1.0f), 1.0f);
    const std::size_t half = geometry.positions.size();
    for (std::size_t i = 0; i < half; ++i) {
        const glm::vec3 mirrored = geometry.positions[i] * glm::vec3(1.0f, 1.0f, -1.0f);
        geometry.positions.push_back(mirrored);
        geometry.normals.push_back(mirrored);
    }
    geometry.parts.assign(2, {});
    for (std::size_t t = 0; t < dome.indices.size(); t += 3) {
        float x = 0.0f, y = 0.0f;  // of the middle, times 3
        for (std::size_t i = t; i < t + 3; ++i) {
            x += geometry.positions[dome.indices[i]].x;
            y += geometry.positions[dome.indices[i]].y;
        }
        const std::size_t upper = x * y > 0.0f ? 0 : 1;
        for (std::size_t i = 0; i < 3; ++i) {
            geometry.parts[upper].push_back(dome.indices[t + i]);
            geometry.parts[1 - upper].push_back(static_cast<std::uint16_t>(half + dome.indices[t + 2 - i]));
        }
    }
    return geometry;
}

Geometry polyhedron(const renderer::ConvexShape& shape) {
    return placed(renderer::convex_mesh(shape), renderer::half_extents(shape), renderer::roundness(shape));
}

Geometry rod() {
    return turned({{1.0f, -1.0f, 0.0f, -1.0f, Ring::below},
                   {1.0f, -1.0f, 1.0f, 0.0f},
                   {1.0f, 1.0f, 1.0f, 0.0f, Ring::wall},
                   {1.0f, 1.0f, 0.0f, 1.0f, Ring::above}});
}

Geometry arrow() {
    constexpr float shaft = 0.025f, head = 0.075f, neck = 0.75f;
    const float slant = std::hypot(1.0f - neck, head);
    return turned({{shaft, 0.0f, 0.0f, -1.0f, Ring::below},
                   {shaft, 0.0f, 1.0f, 0.0f},
                   {shaft, neck, 1.0f, 0.0f, Ring::wall},
                   {head, neck, 0.0f, -1.0f, Ring::below},
                   {head, neck, (1.0f - neck) / slant, head / slant},
                   {0.0f, 1.0f, (1.0f - neck) / slant, head / slant, Ring::wall}});
}

Geometry polygon(const std::vector<engine::Vector3>& corners) {
    const glm::vec3 normal = to_glm(area_of(corners).normalized());
    Geometry geometry;
    Triangles fan;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        geometry.positions.push_back(to_glm(corners[i]));
        geometry.normals.push_back(normal);
        if (i < 2) continue;
        for (const std::size_t corner : {std::size_t{0}, i - 1, i}) {
            fan.push_back(static_cast<std::uint16_t>(corner));
        }
    }
    geometry.parts.push_back(fan);
    return geometry;
}

}  // namespace pushfactor::demos::pictures::gltf
