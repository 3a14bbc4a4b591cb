#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace pushfactor::renderer {

// A rectangle of the frame in pixels, from its lower left corner, as in GL.
struct PixelArea {
    int x;
    int y;
    int width;
    int height;

    bool operator==(const PixelArea&) const = default;
};

// Set of square tiles of a frame that contain something, or might. World frame, m; allows for drawing up to two
// pixels beyond the added geometry.
class Tiles {
  public:
    static constexpr int side = 32;  // pixels

    // Size of the frame, pixels; initially empty.
    Tiles(int width, int height);

    int columns() const { return columns_; }
    int rows() const { return rows_; }
    bool has(int column, int row) const { return marked_[index(column, row)]; }
    bool none() const;

    // Adds all tiles in which a part of the ball is visible.
    void add_ball(const glm::mat4& world_to_clip, const glm::vec3& centre, float radius);

    // Adds all tiles in which a part of a ball's straight sweep is visible, and some around them.
    void add_swept_ball(const glm::mat4& world_to_clip, const glm::vec3& from, const glm::vec3& to, float radius);

    // Adds all tiles in which a part of a convex polygon is visible, and some around them.
    void add_polygon(const glm::mat4& world_to_clip, std::span<const glm::vec3> corners);

    void add(const Tiles& other);
    void add_all();
    void keep_only(const Tiles& other);

    // Whether a part of the ball may be visible in one of these tiles.
    bool show_ball(const glm::mat4& world_to_clip, const glm::vec3& centre, float radius) const;

    // These tiles and their neighbours.
    Tiles with_neighbours() const;

    // The pixels of tiles accepted by `wanted(column, row)`, in a small number of disjoint areas.
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
    // Columns and rows, inclusive; empty if last < first.
    struct Range {
        int first_column = 0, last_column = -1;
        int first_row = 0, last_row = -1;
    };

    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column);
    }
    // Arguments in clip space divided by w, where the frame is -1..1.
    Range range(const glm::vec2& low, const glm::vec2& high) const;
    void add(const Range& range);
    PixelArea pixels(int first_column, int end_column, int row) const;
    // Adds an area, or extends the one below it.
    static void join(std::vector<PixelArea>& areas, const PixelArea& area);

    int width_;
    int height_;
    int columns_;
    int rows_;
    std::vector<bool> marked_;
};

}  // namespace pushfactor::renderer
