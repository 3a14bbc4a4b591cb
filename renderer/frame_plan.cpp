#include "renderer/frame_plan.h"

#include <glm/common.hpp>
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

FramePlan::Part runs(const Tiles& edged, const Tiles& shadowed, bool of_edged, int width, int height) {
    FramePlan::Part part;
    for (int row = 0; row < edged.rows(); ++row) {
        for (int column = 0; column < edged.columns();) {
            const int first = column;
            const bool wanted = edged.has(first, row) == of_edged;
            const bool dark = shadowed.has(first, row);
            while (column < edged.columns() && (edged.has(column, row) == of_edged) == wanted &&
                   shadowed.has(column, row) == dark) {
                ++column;
            }
            if (!wanted) continue;
            const int x = Tiles::side * first;
            const int y = Tiles::side * row;
            (dark ? part.shadowed : part.lit)
                .push_back({x, y, std::min(Tiles::side * column, width) - x, std::min(Tiles::side, height - y)});
        }
    }
    return part;
}

}  // namespace

Tiles::Tiles(int width, int height)
    : width_(width),
      height_(height),
      columns_((width + side - 1) / side),
      rows_((height + side - 1) / side),
      marked_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

void Tiles::add(const glm::vec2& low, const glm::vec2& high) {
    // What is drawn at least so wide, and samples beside the centre of a pixel.
    constexpr float margin = 2.0f;  // pixels
    const auto tile = [](float clip, int pixels, float beyond) {
        const float pixel = 0.5f * (clip + 1.0f) * static_cast<float>(pixels) + beyond;
        return static_cast<int>(std::floor(std::clamp(pixel, -1.0f, static_cast<float>(pixels)) / side));
    };
    if (!(low.x <= 1.5f && low.y <= 1.5f && high.x >= -1.5f && high.y >= -1.5f)) return;
    const int last_column = std::min(tile(high.x, width_, margin), columns_ - 1);
    const int last_row = std::min(tile(high.y, height_, margin), rows_ - 1);
    for (int row = std::max(tile(low.y, height_, -margin), 0); row <= last_row; ++row) {
        for (int column = std::max(tile(low.x, width_, -margin), 0); column <= last_column; ++column) {
            marked_[index(column, row)] = true;
        }
    }
}

void Tiles::add_ball(const glm::mat4& world_to_clip, const glm::vec3& centre, float radius) {
    const glm::vec4 middle = world_to_clip * glm::vec4(centre, 1.0f);
    // How far each clip coordinate changes within the ball: the length of its row of the matrix.
    glm::vec4 reach;
    for (int i = 0; i < 4; ++i) {
        reach[i] = radius * glm::length(glm::vec3(world_to_clip[0][i], world_to_clip[1][i], world_to_clip[2][i]));
    }
    const float nearest = middle.w - reach.w;
    const float farthest = middle.w + reach.w;
    if (farthest <= 0.0f) return;  // behind the eye
    if (!(nearest > 1e-3f * farthest)) return add(glm::vec2(-1.0f), glm::vec2(1.0f));
    const glm::vec2 low = glm::vec2(middle) - glm::vec2(reach);
    const glm::vec2 high = glm::vec2(middle) + glm::vec2(reach);
    add(glm::min(low / nearest, low / farthest), glm::max(high / nearest, high / farthest));
}

void Tiles::add_polygon(const glm::mat4& world_to_clip, const std::vector<glm::vec3>& corners) {
    glm::vec2 low(1e30f);
    glm::vec2 high(-1e30f);
    for (const glm::vec3& corner : corners) {
        const glm::vec4 clip = world_to_clip * glm::vec4(corner, 1.0f);
        // Beside or behind the eye a corner is nowhere in the picture, and the edges to it could be anywhere.
        if (!(clip.w > 1e-3f * glm::length(glm::vec3(clip)))) return add(glm::vec2(-1.0f), glm::vec2(1.0f));
        low = glm::min(low, glm::vec2(clip) / clip.w);
        high = glm::max(high, glm::vec2(clip) / clip.w);
    }
    add(low, high);
}

FramePlan plan_frame(int width, int height, const glm::mat4& world_to_clip, const Bodies& bodies,
                     const Picture& picture, const glm::vec3& towards_sun, float texel) {
    // A sun that low does not light the ground.
    const bool casts = picture.ground && towards_sun.y > 1e-4f;
    // The shadow is wider than the body by the filter of the map and the step off the ground before the lookup.
    const float blur = 6.0f * texel;
    Tiles edged(width, height);
    Tiles shadowed(width, height);
    for (const Instance& body : bodies.all()) {
        cover_with_balls(body, [&](const glm::vec3& centre, float radius) {
            edged.add_ball(world_to_clip, centre, radius);
            if (!casts) return;
            const float along = (centre.y - picture.ground->height) / towards_sun.y;
            const float reach = (radius + blur) / towards_sun.y;
            shadowed.add_ball(world_to_clip, centre - along * towards_sun, reach);
        });
    }
    for (const Panel& panel : picture.panels) edged.add_polygon(world_to_clip, panel.corners);
    return {.bare = runs(edged, shadowed, false, width, height),
            .edged = runs(edged, shadowed, true, width, height)};
}

}  // namespace pushfactor::renderer
