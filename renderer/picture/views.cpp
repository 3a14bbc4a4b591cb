#include "renderer/picture/views.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pushfactor::renderer {
namespace {

// A direction that is up on the screen: y, except when looking straight along it.
glm::vec3 screen_up(const glm::vec3& view_direction) {
    const bool vertical = std::abs(glm::normalize(view_direction).y) > 0.999f;
    return vertical ? glm::vec3(0.0f, 0.0f, -1.0f) : glm::vec3(0.0f, 1.0f, 0.0f);
}

}  // namespace

float bounding_radius(const Instance& body) {
    return glm::length(body.half_extents);
}

float scale_of(const Camera& camera) {
    return glm::distance(camera.eye, camera.target);
}

glm::mat4 camera_view(const Camera& camera, float aspect, float farthest) {
    const glm::mat4 world_to_eye = glm::lookAt(camera.eye, camera.target, screen_up(camera.target - camera.eye));
    const float nearest = 0.01f * scale_of(camera);
    return glm::perspective(glm::radians(camera.vertical_field_of_view_degrees), aspect, nearest, farthest) *
           world_to_eye;
}

float pixel_at_one_metre(const Camera& camera, int height) {
    const float half_angle = glm::radians(0.5f * camera.vertical_field_of_view_degrees);
    return 2.0f * std::tan(half_angle) / static_cast<float>(height);
}

SunView sun_view(const Camera& camera, const glm::vec3& towards_sun, std::span<const Instance> bodies,
                 int max_side) {
    const glm::mat4 world_to_sun = glm::lookAt(glm::vec3(0.0f), -towards_sun, screen_up(towards_sun));
    const auto seen = [&](const glm::vec3& position) {
        return glm::vec3(world_to_sun * glm::vec4(position, 1.0f));
    };

    const glm::vec3 target = seen(camera.target);
    glm::vec3 low = bodies.empty() ? target : seen(bodies[0].position);
    glm::vec3 high = low;
    for (const Instance& body : bodies) {
        low = glm::min(low, seen(body.position) - bounding_radius(body));
        high = glm::max(high, seen(body.position) + bounding_radius(body));
    }
    // One body far away shall not make the shadows of all others coarse; along the light it does not.
    const float scale = scale_of(camera);
    const glm::vec3 range(4.0f * scale, 4.0f * scale, std::numeric_limits<float>::max());
    low = glm::clamp(low, target - range, target + range);
    high = glm::clamp(high, target - range, target + range);

    // About two pixels of a 720p frame, for soft edges; larger, in small steps, when the bodies need it.
    constexpr float border = 3.0f;  // texels around the bodies, for the filter
    constexpr float step = 32.0f;   // texels between the places where the view may end
    const float room = static_cast<float>(max_side) - 2.0f * (step + border);
    const float extent = std::max(high.x - low.x, high.y - low.y);
    float texel = scale / 700.0f;
    if (extent > room * texel) {
        texel *= std::exp2(std::ceil(32.0f * std::log2(extent / (room * texel))) / 32.0f);
    }
    const glm::vec3 first = step * glm::floor((low / texel - border) / step);
    const glm::vec3 last = step * glm::ceil((high / texel + border) / step);
    // The sun looks along its -z axis.
    const glm::mat4 sun_to_clip = glm::ortho(texel * first.x, texel * last.x, texel * first.y, texel * last.y,
                                             -texel * last.z, -texel * first.z);
    return {sun_to_clip * world_to_sun, static_cast<int>(last.x - first.x), static_cast<int>(last.y - first.y),
            texel};
}

}  // namespace pushfactor::renderer
