#include "renderer/images/tiles.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace pushfactor::renderer {
namespace {

// The smallest rectangle of clip space, divided by w, that holds something; none when it is empty.
struct Seen {
    glm::vec2 low{1e30f};
    glm::vec2 high{-1e30f};

    void add(const Seen& other) {
        low = glm::min(low, other.low);
        high = glm::max(high, other.high);
    }
};

const Seen everywhere{glm::vec2(-1.0f), glm::vec2(1.0f)};

Seen seen_of_ball(const glm::mat4& world_to_clip, const glm::vec3& centre, float radius) {
    const glm::vec4 middle = world_to_clip * glm::vec4(centre, 1.0f);
    // How far each clip coordinate changes within the ball: the length of its row of the matrix.
    glm::vec4 reach;
    for (int i = 0; i < 4; ++i) {
        reach[i] = radius * glm::length(glm::vec3(world_to_clip[0][i], world_to_clip[1][i], world_to_clip[2][i]));
    }
    const float nearest = middle.w - reach.w;
    const float farthest = middle.w + reach.w;
    if (farthest <= 0.0f) return {};  // behind the eye
    if (!(nearest > 1e-3f * farthest)) return everywhere;
    const glm::vec2 low = glm::vec2(middle) - glm::vec2(reach);
    const glm::vec2 high = glm::vec2(middle) + glm::vec2(reach);
    return {glm::min(low / nearest, low / farthest), glm::max(high / nearest, high / farthest)};
}

Seen seen_of_polygon(const glm::mat4& world_to_clip, std::span<const glm::vec3> corners) {
    Seen seen;
    for (const glm::vec3& corner : corners) {
        const glm::vec4 clip = world_to_clip * glm::vec4(corner, 1.0f);
        // Beside or behind the eye a corner is nowhere in the picture, and the edges to it could be anywhere.
        if (!(clip.w > 1e-3f * glm::length(glm::vec3(clip)))) return everywhere;
        seen.add({glm::vec2(clip) / clip.w, glm::vec2(clip) / clip.w});
    }
    return seen;
}

}  // namespace

Tiles::Tiles(int width, int height)
    : width_(width),
      height_(height),
      columns_((width + side - 1) / side),
      rows_((height + side - 1) / side),
      marked_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

bool Tiles::none() const {
    return std::ranges::none_of(marked_, [](bool marked) { return marked; });
}

Tiles::Range Tiles::range(const glm::vec2& low, const glm::vec2& high) const {
    constexpr float margin = 2.0f;  // pixels
    const auto tile = [](float clip, int pixels, float beyond) {
        const float pixel = 0.5f * (clip + 1.0f) * static_cast<float>(pixels) + beyond;
        return static_cast<int>(std::floor(std::clamp(pixel, -1.0f, static_cast<float>(pixels)) / side));
    };
    if (!(low.x <= 1.5f && low.y <= 1.5f && high.x >= -1.5f && high.y >= -1.5f)) return {};
    return {.first_column = std::max(tile(low.x, width_, -margin), 0),
            .last_column = std::min(tile(high.x, width_, margin), columns_ - 1),
            .first_row = std::max(tile(low.y, height_, -margin), 0),
            .last_row = std::min(tile(high.y, height_, margin), rows_ - 1)};
}

void Tiles::add(const Range& range) {
    for (int row = range.first_row; row <= range.last_row; ++row) {
        for (int column = range.first_column; column <= range.last_column; ++column) {
            marked_[index(column, row)] = true;
        }
    }
}

void Tiles::add_ball(const glm::mat4& world_to_clip, const glm::vec3& centre, float radius) {
    const Seen seen = seen_of_ball(world_to_clip, centre, radius);
    add(range(seen.low, seen.high));
}

void Tiles::add_swept_ball(const glm::mat4& world_to_clip, const glm::vec3& from, const glm::vec3& to,
                           float radius) {
    constexpr int pieces = 8;
    const auto at = [&](int piece) { return glm::mix(from, to, static_cast<float>(piece) / pieces); };
    for (int piece = 0; piece < pieces; ++piece) {
        Seen seen = seen_of_ball(world_to_clip, at(piece), radius);
        const Seen end = seen_of_ball(world_to_clip, at(piece + 1), radius);
        // Where one end is behind the eye, what is between them passes it.
        const bool passes = (seen.low.x > seen.high.x) != (end.low.x > end.high.x);
        seen.add(passes ? everywhere : end);
        add(range(seen.low, seen.high));
    }
}

void Tiles::add_polygon(const glm::mat4& world_to_clip, std::span<const glm::vec3> corners) {
    const Seen seen = seen_of_polygon(world_to_clip, corners);
    add(range(seen.low, seen.high));
}

void Tiles::add(const Tiles& other) {
    for (std::size_t i = 0; i < marked_.size(); ++i) marked_[i] = marked_[i] || other.marked_[i];
}

void Tiles::add_all() {
    marked_.assign(marked_.size(), true);
}

void Tiles::keep_only(const Tiles& other) {
    for (std::size_t i = 0; i < marked_.size(); ++i) marked_[i] = marked_[i] && other.marked_[i];
}

bool Tiles::show_ball(const glm::mat4& world_to_clip, const glm::vec3& centre, float radius) const {
    const Seen seen = seen_of_ball(world_to_clip, centre, radius);
    const Range place = range(seen.low, seen.high);
    for (int row = place.first_row; row <= place.last_row; ++row) {
        for (int column = place.first_column; column <= place.last_column; ++column) {
            if (has(column, row)) return true;
        }
    }
    return false;
}

Tiles Tiles::with_neighbours() const {
    Tiles grown = *this;
    for (int row = 0; row < rows_; ++row) {
        for (int column = 0; column < columns_; ++column) {
            if (!has(column, row)) continue;
            grown.add(Range{.first_column = std::max(column - 1, 0),
                            .last_column = std::min(column + 1, columns_ - 1),
                            .first_row = std::max(row - 1, 0),
                            .last_row = std::min(row + 1, rows_ - 1)});
        }
    }
    return grown;
}

PixelArea Tiles::pixels(int first_column, int end_column, int row) const {
    const int x = side * first_column;
    const int y = side * row;
    return {x, y, std::min(side * end_column, width_) - x, std::min(side, height_ - y)};
}

void Tiles::join(std::vector<PixelArea>& areas, const PixelArea& area) {
    const auto below = std::ranges::find_if(areas, [&](const PixelArea& other) {
        return other.x == area.x && other.width == area.width && other.y + other.height == area.y;
    });
    if (below == areas.end()) {
        areas.push_back(area);
    } else {
        below->height += area.height;
    }
}

}  // namespace pushfactor::renderer
