// Broad phase: pairs of colliders that may touch. The bounding boxes are put into the columns of a square grid, and
// in each column those that overlap are found along their order from the bottom up. They are searched with some
// room, and again when one of them has left it; until then only the pairs found are looked at.
#pragma once

#include "engine/base/threads.h"
#include "engine/bodies/awake.h"
#include "engine/bodies/motion.h"
#include "engine/collision/collider.h"

#include <cmath>
#include <span>
#include <vector>

namespace pushfactor::engine::collision {

// Axis-aligned, world frame.
struct BoundingBox {
    Vector3 centre, reach;  // m; reach is half the edge lengths
};

inline bool overlap(const BoundingBox& a, const BoundingBox& b) {
    const auto near = [&](int axis) {
        return std::abs(a.centre[axis] - b.centre[axis]) < a.reach[axis] + b.reach[axis];
    };
    return near(0) && near(1) && near(2);
}

struct Pair {
    int a = 0;  // collider indices, a < b
    int b = 0;
    friend auto operator<=>(const Pair&, const Pair&) = default;  // NOLINT(modernize-use-nullptr)
};

// Pairs of colliders that never touch: those of one group, and single ones.
class PairFilter {
  public:
    // `groups`: number of its group by collider, negative for none; or empty. `pairs` in any order.
    PairFilter(std::vector<int> groups, std::vector<Pair> pairs);

    bool leaves_out(const Pair& pair) const;

  private:
    std::vector<int> groups_;
    std::vector<Pair> pairs_;  // ascending
};

// Bounding box of a finite shape along its motion from `pose` in `dt` [s], wider by `room` [m] on every side.
BoundingBox swept_box(const Shape& shape, const Pose& pose, const Motion& motion, double dt, double room);

class BroadPhase {
  public:
    // Pairs that are never found, from the next search on; null: none. Must outlive its use.
    void leave_out(const PairFilter* filter) {
        filter_ = filter;
        roomy_.clear();
    }

    // All pairs, in ascending order, whose bounding boxes come closer than `margin` (a fraction of each shape's
    // size) now or, with `step`, along their free motions. Never two colliders of one body, never two that are
    // static or not `awake`: their rows could move nothing. Non-finite boxes make no pairs. `poses` are those of
    // the bodies. Only the colliders `moved` (ascending) are updated; the others are where they were in the last
    // call.
    std::span<const Pair> find_pairs(std::span<const Collider> colliders, std::span<const Body> bodies,
                                     std::span<const Pose> poses, double margin, const StepMotions* step,
                                     const Awake& awake, std::span<const int> moved, Threads* threads = nullptr);

    // The same with nothing at rest.
    std::span<const Pair> find_pairs(std::span<const Collider> colliders, std::span<const Body> bodies,
                                     std::span<const Pose> poses, double margin, const StepMotions* step = nullptr);

    // Replaces the bounding box of a finite shape until the next find_pairs().
    void put(int collider, const BoundingBox& box);

    // The pairs with at least one collider in `of` (by collider), with the current boxes. Valid until the next
    // call, like those of find_pairs().
    std::span<const Pair> find_pairs_of(std::span<const char> of, Threads* threads = nullptr);

  private:
    // Bounding box of one finite shape.
    struct Bounds : BoundingBox {
        Vector3 low, high;  // m, its corners, with room for the rounding in overlap()
        int collider = 0;
        int body = 0;
        bool idle = false;    // static or at rest
        bool finite = false;  // the box
        bool wanted = false;  // in the current search
        bool wide = false;    // too wide for the columns
    };
    struct Plane {
        Vector3 point, up;  // m; unit normal
        int collider = 0;
        bool operator==(const Plane&) const = default;
    };
    // A box in one of the columns that it reaches into.
    struct Entry {
        double low = 0.0, high = 0.0;  // m
        int x = 0, z = 0;              // of the column
        int box = 0;
        unsigned first = 0;  // bits for x and z: its first column in this direction
    };

    static void set(Bounds& bounds, const BoundingBox& box);
    void list_shapes(std::span<const Collider> colliders, std::span<const Pose> poses, const StepMotions* step,
                     std::span<const int> moved);
    bool stays_in_room(std::size_t box) const;
    void find_near(std::span<const Collider> colliders, Threads* threads);
    bool is_near(const Pair& pair) const;
    void search(std::vector<Bounds>& boxes, Threads* threads);
    void choose_boxes();
    double column_width();
    void fill_columns();
    void sweep(std::span<Entry> entries, std::vector<Pair>& found) const;
    void add_with_planes_and_wide(int box, std::vector<Pair>& found) const;
    void add_if_near(const Bounds& one, const Bounds& other, std::vector<Pair>& found) const;
    void add(int one, int other, std::vector<Pair>& found) const;

    const PairFilter* filter_ = nullptr;
    std::vector<Bounds> bounds_;  // of the finite shapes
    std::vector<int> place_;      // in bounds_, by collider; -1 for a plane
    std::vector<Plane> planes_;
    std::vector<Pair> pairs_, pairs_before_;

    // Of the last search with room: its boxes and planes, and what it has found.
    std::vector<Bounds> roomy_;
    std::vector<Plane> planes_then_;
    std::vector<Pair> near_;

    // Of the current search.
    std::span<Bounds> searched_;
    std::vector<int> chosen_, wide_;  // boxes
    std::vector<double> widths_;      // m, of the chosen ones
    std::vector<Entry> entries_, entries_before_;
    std::vector<int> begins_;  // of what is sorted last by counting
    Search<Pair> pair_search_;
};

}  // namespace pushfactor::engine::collision
