// Boxes in a hash grid, for finding those that come near each other: a level of cells for each power of two of
// sizes, so that small boxes among large ones cost neither.
#pragma once

#include "engine/base/math.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace pushfactor::engine::collision {

// Along the world axes.
struct BoundingBox {
    Vector3 centre, reach;  // m; reach is half its edges
};

inline bool overlap(const BoundingBox& a, const BoundingBox& b) {
    const auto near = [&](int axis) {
        return std::abs(a.centre[axis] - b.centre[axis]) < a.reach[axis] + b.reach[axis];
    };
    return near(0) && near(1) && near(2);
}

// Boxes are named by their index. What visitors are given has to be compared with overlap(): it is near, not more.
class BoxGrid {
  public:
    // Empties the grid for boxes with indices below `count`.
    void clear(std::size_t count);
    void insert(int index, const BoundingBox& box);
    void remove(int index);

    // Calls `visit(other)` once for each other box in the grid that may overlap `box`, which is in it as `index`.
    template <typename Visit>
    void visit_neighbours(int index, const BoundingBox& box, const Visit& visit) const {
        for (const Level& level : levels_) visit_level(level, index, box, visit);
    }

    // Of all boxes: visits every pair from one of its two.
    template <typename Visit>
    void visit_pairs_from(int index, const BoundingBox& box, const Visit& visit) const {
        const Cell& own = cells_[at(index)];
        for (int other = next_[at(index)]; other >= 0; other = next_[at(other)]) {
            if (cells_[at(other)] == own) visit(other);
        }
        for (const Level& level : levels_) {
            if (level.level == own.level) {
                // Each pair of cells from one side.
                for (int k = 14; k < 27; ++k) visit_cell(neighbour(own, k), index, visit);
            } else if (level.level > own.level) {
                visit_level(level, index, box, visit);
            }
        }
    }

  private:
    struct Cell {
        int level = 0;  // its edge is 2^level m
        std::int64_t x = 0, y = 0, z = 0;
        friend bool operator==(const Cell&, const Cell&) = default;
    };
    struct Level {
        int level = 0;
        int count = 0;      // of boxes
        Vector3 low, high;  // m, around all boxes that have been there since clear()
    };

    static std::size_t at(int index) { return static_cast<std::size_t>(index); }
    static Cell cell_of(const Vector3& point, int level);
    static Cell neighbour(const Cell& cell, int k) {
        return {cell.level, cell.x + k / 9 - 1, cell.y + k / 3 % 3 - 1, cell.z + k % 3 - 1};
    }
    std::size_t bucket_of(const Cell& cell) const;
    Level& level_at(int level);
    bool may_overlap(const Level& level, const BoundingBox& box) const;
    bool covers_many_cells(const BoundingBox& box, int level) const;

    template <typename Visit>
    void visit_cell(const Cell& cell, int index, const Visit& visit) const {
        for (int other = heads_[bucket_of(cell)]; other >= 0; other = next_[at(other)]) {
            // Others may have come into the same bucket.
            if (other != index && cells_[at(other)] == cell) visit(other);
        }
    }

    // Boxes no longer than a cell overlap only when their centres are in the same or in adjacent cells.
    template <typename Visit>
    void visit_level(const Level& level, int index, const BoundingBox& box, const Visit& visit) const {
        if (level.count == 0 || !may_overlap(level, box)) return;
        const int own = cells_[at(index)].level;
        if (level.level >= own) {
            const Cell home = level.level == own ? cells_[at(index)] : cell_of(box.centre, level.level);
            for (int k = 0; k < 27; ++k) visit_cell(neighbour(home, k), index, visit);
        } else if (covers_many_cells(box, level.level)) {
            for (int other = 0; other < static_cast<int>(cells_.size()); ++other) {
                if (held_[at(other)] && cells_[at(other)].level == level.level) visit(other);
            }
        } else {
            // Half a cell for the other box, and a quarter for roundings.
            const Vector3 reach = box.reach + Vector3::Constant(std::ldexp(0.75, level.level));
            const Cell low = cell_of(box.centre - reach, level.level),
                       high = cell_of(box.centre + reach, level.level);
            for (std::int64_t x = low.x; x <= high.x; ++x) {
                for (std::int64_t y = low.y; y <= high.y; ++y) {
                    for (std::int64_t z = low.z; z <= high.z; ++z) visit_cell({level.level, x, y, z}, index, visit);
                }
            }
        }
    }

    std::vector<Cell> cells_;    // of the centres, with edges no shorter than the box's; by index
    std::vector<char> held_;     // whether there is such a box; by index
    std::vector<Level> levels_;  // ascending
    std::vector<int> heads_;     // hash table: the first of each bucket, -1 for none
    std::vector<int> next_;      // the next of the same bucket
};

}  // namespace pushfactor::engine::collision
