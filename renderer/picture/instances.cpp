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

struct Size {
    glm::vec3 half_extents;  // m
    float bevel;             // m
};

Size size_of(const Box& box) {
    constexpr float bevel = 0.08f;  // of the smallest half extent
    const glm::vec3& half = box.half_extents;
    return {half, bevel * std::min({half.x, half.y, half.z})};
}
Size size_of(const Sphere& sphere) {
    return {glm::vec3(sphere.radius), sphere.radius};
}
Size size_of(const Polyhedron& polyhedron) {
    return {half_extents(*polyhedron), roundness(*polyhedron)};
}

}  // namespace

Instance instance_of(const Body& body, std::size_t number) {
    const Size size = std::visit([](const auto& shape) { return size_of(shape); }, body.shape);
    const glm::quat& turn = body.orientation;
    return {.position = body.position,
            .bevel = size.bevel,
            .orientation = {turn.x, turn.y, turn.z, turn.w},
            .half_extents = size.half_extents,
            .colour = glm::convertSRGBToLinear(body.colour),
            .number = static_cast<float>(number)};
}

Instance instance_of(const Bar& bar, std::size_t number) {
    const float length = glm::distance(bar.from, bar.to);
    const glm::vec3 direction = length > 0.0f ? (bar.to - bar.from) / length : glm::vec3(0.0f, 1.0f, 0.0f);
    return {.position = 0.5f * (bar.from + bar.to),
            .bevel = bar.radius,
            .orientation = turn_from_y(direction),
            .half_extents = {bar.radius, 0.5f * length + bar.radius, bar.radius},
            .colour = glm::convertSRGBToLinear(bar.colour),
            .number = static_cast<float>(number)};
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
