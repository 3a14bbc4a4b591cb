#pragma once

#include "renderer/meshes/instanced_mesh.h"
#include "renderer/picture/picture.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <span>

namespace pushfactor::renderer {

// Radius of a bounding sphere of the body around its position, m.
float bounding_radius(const Instance& body);

// Reference distance of haze, ground and shadows, m: distance of the camera's target.
float scale_of(const Camera& camera);

// Transform from world to clip space. `aspect` is width over height. Shows everything from a hundredth of the
// picture's scale up to `farthest` m from the eye.
glm::mat4 camera_view(const Camera& camera, float aspect, float farthest);

// Side length of a pixel in the world at a distance of 1 m, m; proportional to the distance.
float pixel_at_one_metre(const Camera& camera, int height);

// Shadow view: parallel projection along the light, just large enough for all bodies.
struct SunView {
    glm::mat4 world_to_clip;
    int width;    // texels
    int height;   // texels
    float texel;  // side length of a texel in the world, m

    bool operator==(const SunView&) const = default;
};

// Shadow views of one direction of the sky: from there, and from the opposite side, where the ground is.
struct SkyView {
    SunView above;
    SunView below;
    glm::vec3 towards_sky;  // unit length
    float weight;           // SampleOffset::sky_weight

    bool operator==(const SkyView&) const = default;
};

// A view of all bodies, or at least of those near the camera's target, with at most `max_side` texels per side. It
// changes only occasionally while bodies move, and by whole texels, so that shadows of resting bodies do not
// flicker.
SunView sun_view(const Camera& camera, const glm::vec3& towards_sun, std::span<const Instance> bodies,
                 int max_side);

}  // namespace pushfactor::renderer
