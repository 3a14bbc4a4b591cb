#include "renderer/instances.h"

#include "renderer/views.h"

#include <glm/gtc/color_space.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace pushfactor::renderer {

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
             .colour = glm::convertSRGBToLinear(box.colour)});
    }
    return instances;
}

Instance ground_instance(const Ground& ground, const glm::vec3& centre, float half_side) {
    return {.position = {centre.x, ground.height, centre.z},
            .bevel = 0.0f,
            .orientation = {0.0f, 0.0f, 0.0f, 1.0f},
            .half_extents = {half_side, 0.0f, half_side},
            .colour = glm::vec3(0.42f, 0.425f, 0.435f)};
}

std::vector<Instance> touching(const Ground& ground, std::span<const Instance> bodies) {
    std::vector<Instance> near;
    std::ranges::copy_if(bodies, std::back_inserter(near), [&](const Instance& body) {
        return std::abs(body.position.y - ground.height) < 2.0f * bounding_radius(body);
    });
    return near;
}

}  // namespace pushfactor::renderer
