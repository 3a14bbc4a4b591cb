#include "renderer/frames/sphere_meshes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace pushfactor::renderer {
namespace {

// The largest radius in pixels for each level but the last: between the corners of the outline, which has 12,
// 20, 32 or 96 of them, it keeps within 0.3 pixels of the circle.
constexpr std::array largest_radius{9.0f, 24.0f, 62.0f};

}  // namespace

SphereMeshes::SphereMeshes(const Gl& gl)
    : levels_{InstancedMesh(gl, dome_mesh(12, 2)), InstancedMesh(gl, dome_mesh(20, 2)),
              InstancedMesh(gl, dome_mesh(32, 4)), InstancedMesh(gl, dome_mesh(96, 12))} {}

void SphereMeshes::set_instances(std::span<const Instance> spheres, const glm::vec3& eye, float pixel) {
    std::array<std::vector<Instance>, std::tuple_size_v<decltype(levels_)>> sorted;
    for (const Instance& sphere : spheres) {
        const float radius = sphere.bevel / (pixel * glm::distance(eye, sphere.position));  // pixels
        const auto* level = std::ranges::find_if(largest_radius, [&](float largest) { return radius <= largest; });
        sorted[static_cast<std::size_t>(level - largest_radius.begin())].push_back(sphere);
    }
    for (std::size_t level = 0; level < levels_.size(); ++level) levels_[level].set_instances(sorted[level]);
}

void SphereMeshes::draw() const {
    for (const InstancedMesh& level : levels_) level.draw();
}

}  // namespace pushfactor::renderer
