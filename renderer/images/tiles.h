#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace pushfactor::renderer {

// A rectangle of the frame in pixels, from its lower left corner, as GL counts.
struct PixelArea {
    int x;
    int y;
    int width;
    int height;

    bool operator==(const PixelArea&) const = default;
};

// Which square tiles of a frame something is in, or might be. World frame, m; what is drawn is up to two pixels
// wider than the geometry that is added.
class Tiles {
  public:
    static constexpr int side = 32;  // pixels

    // The frame's size, pixels; nothing is in it yet.
    Tiles(int width, int height);

    int columns() const { return columns_; }
    int rows() const { return rows_; }
    bool has(int column, int row) const { return marked_[index(column, row)]; }
    bool none() const;

    // Adds all tiles in which the camera sees a part of a ball.
    void add_ball(const glm::mat4& world_to_clip, const glm::vec3& centre, float radius);

    // Adds all tiles in which it sees a part of what a ball sweeps that moves straight from one place to another,
    // and some around them.
    void add_swept_ball(const glm::mat4& world_to_clip, const glm::vec3& from, const glm::vec3& to, float radius);

    // Adds all tiles in which it sees a part of a convex polygon, and some around them.
    void add_polygon(const glm::mat4& world_to_clip, std::span<const glm::vec3> corners);

    void add(const Tiles& other);
    void add_all();
    void keep_only(const Tiles& other);

    // Whether the camera may see a part of the ball in one of these tiles.
    bool show_ball(const glm::mat4& world_to_clip, const glm::vec3& centre, float radius) const;

    // These tiles and all that touch them.
    Tiles with_neighbours() const;

    // The pixels of those tiles that `wanted(column, row)` accepts, each in one area, of few areas.
    template <typename Wanted>
    std::vector<PixelArea> areas(const Wanted& wanted) const {
        std::vector<PixelArea> found;
        for (int row = 0; row < rows_; ++row) {
            for (int column = 0; column < columns_;) {
                const int first = column;
                while (column < columns_ && has(column, row) && wanted(column, row)) ++column;
                if (column > first) join(found, pixels(first, column, row));
                if (column == first) ++column;
            }
        }
        return found;
    }
    std::vector<PixelArea> areas() const {
        return areas([](int, int) { return true; });
    }

  private:
    // Columns and rows, the last ones included; empty where a last one is smaller than the first.
    struct Range {
        int first_column = 0, last_column = -1;
        int first_row = 0, last_row = -1;
    };

    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column);
    }
    // In clip space divided by w: what is drawn has both coordinates in -1..1.
    Range range(const glm::vec2& low, const glm::vec2& high) const;
    void add(const Range& range);
    PixelArea pixels(int first_column, int end_column, int row) const;
    // Adds an area, or lets the one below it grow.
    static void join(std::vector<PixelArea>& areas, const PixelArea& area);

    int width_;
    int height_;
    int columns_;
    int rows_;
    std::vector<bool> marked_;
};

}  // namespace pushfactor::renderer
