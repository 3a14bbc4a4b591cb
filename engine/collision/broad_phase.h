// Which pairs of colliders may touch. Candidates are found in a hashed grid with one level of cells a power of two
// of size, so that the cost is linear in practice, for equal and for very different sizes. They are found for boxes
// that are somewhat wider than the shapes, and serve for as long as every shape stays within its wide box: in a
// scene at rest the grid is not filled again.
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
    friend auto operator<=>(const Pair&, const Pair&) = default;  // NOLINT(modernize-use-nullptr)
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
        Vector3 centre, reach;  // m; reach is half its edges
        double slack = 0.0;     // m, by which the wide box reaches farther
        int collider = 0;
        int body = 0;
        bool fixed = false;  // of a static body
    };
    struct Plane {
        Vector3 point, up;  // m; unit length
        int collider = 0;
    };
    // Two boxes, or a plane (`other` counts down from -1) and a box.
    struct Candidate {
        Pair pair;
        int box = 0;
        int other = 0;
    };

    static Cell cell_of(const Vector3& centre, int level);
    std::size_t bucket_of(const Cell& cell) const;
    void bound(std::span<const Collider> colliders, std::span<const Body> bodies, std::span<const Pose> poses,
               double margin);
    bool within_wide() const;
    void find_candidates();
    void fill_grid();
    void add_with_planes();
    void add_with_neighbours(int index);
    void add_with_cell(int index, const Cell& cell);
    void add_if_near(int index, int other);

    std::vector<Bounds> bounds_;  // of the finite shapes, as they are
    std::vector<Plane> planes_;

    // As they were when the candidates were found.
    std::vector<Bounds> wide_;  // with wide reach
    std::vector<Plane> wide_planes_;
    std::vector<Candidate> candidates_;  // in ascending order of the pair

    std::vector<Cell> cells_;  // of the centres of the wide boxes, with edges no shorter than theirs
    std::vector<int> levels_;  // that occur, ascending
    std::vector<int> heads_;   // hash table: the first of each bucket, index into wide_, -1 for none
    std::vector<int> next_;    // the next of the same bucket
    std::vector<Pair> pairs_;
};

}  // namespace pushfactor::engine::collision
