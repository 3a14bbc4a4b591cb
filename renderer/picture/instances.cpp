#include "renderer/picture/instances.h"

#include "renderer/picture/views.h"

#include <glm/geometric.hpp>
#include <glm/gtc/color_space.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace pushfactor::renderer {
namespace {

// Shortest rotation from the y axis to a unit direction or to its opposite, whichever is nearer: a bar looks the
// same from both ends, and the rotation to -y would not be unique.
glm::vec4 turn_from_y(glm::vec3 direction) {
    if (direction.y < 0.0f) direction = -direction;
    return glm::normalize(glm::vec4(direction.z, 0.0f, -direction.x, 1.0f + direction.y));
}

}  // namespace

std::vector<Instance> box_instances(std::span<const Box> boxes) {
    constexpr float bevel = 0.08f;  // of the smallest half extent
    std::vector<Instance> instances;
    instances.reserve(boxes.size());
    for (const Box& box : boxes) {
        const glm::vec3& half = box.half_extents;
        instances.push_back(
            {.position = box.position,
             .bevel = bevel * std::min({half.x, half.y, half.z}),
             .orientation = {box.orientation.x, box.orientation.y, box.orientation.z, box.orientation.w},
             .half_extents = half,
             .colour = glm::convertSRGBToLinear(box.colour),
             .number = static_cast<float>(instances.size())});
    }
    return instances;
}

std::vector<Instance> sphere_instances(std::span<const Sphere> spheres) {
    std::vector<Instance> instances;
    instances.reserve(spheres.size());
    for (const Sphere& sphere : spheres) {
        const glm::quat& turn = sphere.orientation;
        instances.push_back({.position = sphere.position,
                             .bevel = sphere.radius,
                             .orientation = {turn.x, turn.y, turn.z, turn.w},
                             .half_extents = glm::vec3(sphere.radius),
                             .colour = glm::convertSRGBToLinear(sphere.colour),
                             .number = static_cast<float>(instances.size())});
    }
    return instances;
}

std::vector<Instance> polyhedron_instances(std::span<const Polyhedron> polyhedra) {
    std::vector<Instance> instances;
    instances.reserve(polyhedra.size());
    for (const Polyhedron& polyhedron : polyhedra) {
        const glm::quat& turn = polyhedron.orientation;
        instances.push_back({.position = polyhedron.position,
                             .bevel = roundness(*polyhedron.shape),
                             .orientation = {turn.x, turn.y, turn.z, turn.w},
                             .half_extents = half_extents(*polyhedron.shape),
                             .colour = glm::convertSRGBToLinear(polyhedron.colour),
                             .number = static_cast<float>(instances.size())});
    }
    return instances;
}

std::vector<Instance> bar_instances(std::span<const Bar> bars) {
    std::vector<Instance> instances;
    instances.reserve(bars.size());
    for (const Bar& bar : bars) {
        const float length = glm::distance(bar.from, bar.to);
        const glm::vec3 direction = length > 0.0f ? (bar.to - bar.from) / length : glm::vec3(0.0f, 1.0f, 0.0f);
        instances.push_back({.position = 0.5f * (bar.from + bar.to),
                             .bevel = bar.radius,
                             .orientation = turn_from_y(direction),
                             .half_extents = {bar.radius, 0.5f * length + bar.radius, bar.radius},
                             .colour = glm::convertSRGBToLinear(bar.colour),
                             .number = static_cast<float>(instances.size())});
    }
    return instances;
}

Instance ground_instance(const Ground& ground, const glm::vec3& centre, float half_side) {
    return {.position = {centre.x, ground.height, centre.z},
            .bevel = 0.0f,
            .orientation = {0.0f, 0.0f, 0.0f, 1.0f},
            .half_extents = {half_side, 0.0f, half_side},
            .colour = glm::vec3(0.42f, 0.425f, 0.435f),
            .number = 0.0f};
}

float contact_reach(const Instance& body) {
    const glm::vec3& half = body.half_extents;
    return glm::length(half) + std::min({half.x, half.y, half.z});
}

std::vector<Instance> touching(const Ground& ground, std::span<const Instance> bodies) {
    std::vector<Instance> near;
    std::ranges::copy_if(bodies, std::back_inserter(near), [&](const Instance& body) {
        return std::abs(body.position.y - ground.height) < 2.0f * bounding_radius(body);
    });
    return near;
}

}  // namespace pushfactor::renderer
