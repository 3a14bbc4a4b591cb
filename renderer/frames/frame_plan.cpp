#include "renderer/frames/frame_plan.h"

#include "renderer/picture/instances.h"
#include "renderer/picture/views.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace pushfactor::renderer {
namespace {

// Calls `visit(centre, radius)` for balls that hold the body together: a row of them for a long body.
template <typename Visit>
void cover_with_balls(const Instance& body, const Visit& visit) {
    constexpr float most = 24.0f;
    const glm::vec3& half = body.half_extents;
    const int axis = half.x > half.y ? (half.x > half.z ? 0 : 2) : (half.y > half.z ? 1 : 2);
    glm::vec3 piece = half;
    piece[axis] = 0.0f;
    const float thickness = glm::length(piece);
    const float count = std::clamp(std::ceil(half[axis] / std::max(thickness, 1e-30f)), 1.0f, most);
    piece[axis] = half[axis] / count;

    glm::vec3 along(0.0f);
    along[axis] = 1.0f;
    const glm::vec4& q = body.orientation;
    along = glm::quat(q.w, q.x, q.y, q.z) * along;
    for (float i = 0.5f; i < count; i += 1.0f) {
        visit(body.position + (2.0f * i / count - 1.0f) * half[axis] * along, glm::length(piece));
    }
}

// By how much a shadow is wider than its body: the filter of the map and the step off the ground before the lookup.
float blur(const FrameView& view) {
    return 6.0f * view.texel;
}

}  // namespace

Tiles occupied_tiles(const FrameView& view, std::span<const Instance> bodies, std::span<const Panel> panels) {
    Tiles tiles(view.width, view.height);
    for (const Instance& body : bodies) {
        cover_with_balls(body, [&](const glm::vec3& centre, float radius) {
            tiles.add_ball(view.world_to_clip, centre, radius);
        });
    }
    for (const Panel& panel : panels) tiles.add_polygon(view.world_to_clip, panel.corners);
    return tiles;
}

Tiles shadowed_tiles(const FrameView& view, std::span<const Instance> bodies, const Ground& ground) {
    Tiles tiles(view.width, view.height);
    // A sun that low does not light the ground.
    if (view.towards_sun.y <= 1e-4f) return tiles;
    for (const Instance& body : bodies) {
        cover_with_balls(body, [&](const glm::vec3& centre, float radius) {
            const float along = (centre.y - ground.height) / view.towards_sun.y;
            const float reach = (radius + blur(view)) / view.towards_sun.y;
            tiles.add_ball(view.world_to_clip, centre - along * view.towards_sun, reach);
        });
    }
    return tiles;
}

Tiles touched_tiles(const FrameView& view, std::span<const Instance> bodies, const Ground& ground) {
    Tiles tiles(view.width, view.height);
    for (const Instance& body : touching(ground, bodies)) {
        const float reach = contact_reach(body);
        const glm::vec3 below(body.position.x, ground.height, body.position.z);
        const std::array corners{below + glm::vec3(-reach, 0.0f, -reach), below + glm::vec3(reach, 0.0f, -reach),
                                 below + glm::vec3(reach, 0.0f, reach), below + glm::vec3(-reach, 0.0f, reach)};
        tiles.add_polygon(view.world_to_clip, corners);
    }
    return tiles;
}

Tiles swept_tiles(const FrameView& view, std::span<const Instance> bodies, float distance) {
    Tiles tiles(view.width, view.height);
    for (const Instance& body : bodies) {
        cover_with_balls(body, [&](const glm::vec3& centre, float radius) {
            tiles.add_swept_ball(view.world_to_clip, centre, centre - distance * view.towards_sun,
                                 radius + blur(view));
        });
    }
    return tiles;
}

FramePlan plan_frame(const Tiles& drawn, const Tiles& shadowed) {
    return {.lit = drawn.areas([&](int column, int row) { return !shadowed.has(column, row); }),
            .shadowed = drawn.areas([&](int column, int row) { return shadowed.has(column, row); })};
}

}  // namespace pushfactor::renderer
