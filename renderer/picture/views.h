#pragma once

#include "renderer/meshes/instanced_mesh.h"
#include "renderer/picture/picture.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <span>

namespace pushfactor::renderer {

// Radius about its position of a sphere that holds the body, m.
float bounding_radius(const Instance& body);

// The distance in m by which haze, ground and shadows are measured: how far away the camera's target is.
float scale_of(const Camera& camera);

// World to clip space of a camera. `aspect` is width over height. Shows everything from a hundredth of the
// picture's scale up to `farthest` m from the eye.
glm::mat4 camera_view(const Camera& camera, float aspect, float farthest);

// Side of a pixel in the world at a distance of 1 m, m; it grows with the distance.
float pixel_at_one_metre(const Camera& camera, int height);

// How the sun sees the bodies: parallel light, an image just large enough for all of them.
struct SunView {
    glm::mat4 world_to_clip;
    int width;    // texels
    int height;   // texels
    float texel;  // side of one texel in the world, m

    bool operator==(const SunView&) const = default;
};

// A view of all bodies, or at least of those near the camera's target, in at most `max_side` texels a side. It
// changes only now and then while bodies move, and by whole texels, so that the shadows of the resting ones keep
// still.
SunView sun_view(const Camera& camera, const glm::vec3& towards_sun, std::span<const Instance> bodies,
                 int max_side);

}  // namespace pushfactor::renderer
