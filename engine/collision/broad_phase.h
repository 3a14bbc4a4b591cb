// Which pairs of colliders may touch: a hashed grid with one level of cells a power of two of size, so that the
// cost is linear in practice, for equal and for very different sizes.
#pragma once

#include "engine/collision/collider.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace pushfactor::engine::collision {

struct Pair {
    int a = 0;  // collider indices, a < b
    int b = 0;
    friend auto operator<=>(const Pair&, const Pair&) = default;
};

class BroadPhase {
  public:
    // All pairs whose bounding boxes come closer than `margin` (a fraction of each shape's size) allows, in
    // ascending order. Never two colliders of one body, never two static bodies: such a row could move nothing.
    // `poses` are those of the bodies.
    std::span<const Pair> find_pairs(std::span<const Collider> colliders, std::span<const Body> bodies,
                                     std::span<const Pose> poses, double margin);

  private:
    struct Cell {
        int level = 0;  // its edge is 2^level m
        std::int64_t x = 0, y = 0, z = 0;
        friend bool operator==(const Cell&, const Cell&) = default;
    };
    // The bounding box of one finite shape.
    struct Bounds {
        Vector3 low, high;  // m
        int collider = 0;
        int body = 0;
        bool fixed = false;  // of a static body
        Cell cell;           // of its centre, with edges no shorter than the box's; set by fill_grid
    };

    static Cell cell_of(const Vector3& centre, int level);
    std::size_t bucket_of(const Cell& cell) const;
    void bound(std::span<const Collider> colliders, std::span<const Body> bodies, std::span<const Pose> poses,
               double margin);
    void fill_grid();
    void pair_with_planes(std::span<const Collider> colliders, std::span<const Pose> poses);
    void pair_with_neighbours(int index);
    void pair_with_cell(int index, const Cell& cell);
    void pair_if_near(const Bounds& box, const Bounds& other);

    std::vector<Bounds> bounds_;  // of the finite shapes
    std::vector<int> planes_;
    std::vector<int> levels_;  // that occur, ascending
    std::vector<int> heads_;   // hash table: the first of each bucket, index into bounds_, -1 for none
    std::vector<int> next_;    // the next of the same bucket
    std::vector<Pair> pairs_;
};

}  // namespace pushfactor::engine::collision
