// Broad phase: pairs of colliders that may touch. Candidates are found for boxes somewhat wider than the shapes
// and stay valid while each shape is within its wide box; new ones are found only for shapes that have left
// theirs, so bodies that hold still cost nothing.
#pragma once

#include "engine/base/threads.h"
#include "engine/bodies/awake.h"
#include "engine/bodies/motion.h"
#include "engine/collision/box_grid.h"
#include "engine/collision/collider.h"

#include <span>
#include <vector>

namespace pushfactor::engine::collision {

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
    void leave_out(const PairFilter* filter) { filter_ = filter; }

    // All pairs, in ascending order, whose bounding boxes come closer than `margin` (a fraction of each shape's
    // size) now or, with `step`, along their free motions. Never two colliders of one body, never two that are
    // static or not `awake`: their rows could move nothing. `poses` are those of the bodies. Only the colliders
    // `moved` (ascending) are updated; the others are where they were in the last call. `threads` share the work;
    // null: one thread.
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
    std::span<const Pair> find_pairs_of(const std::vector<bool>& of);

  private:
    // Bounding box of one finite shape.
    struct Bounds : BoundingBox {
        double slack = 0.0;  // m, extra reach of the wide box
        int collider = 0;
        int body = 0;
        bool idle = false;  // static or at rest
    };
    struct Plane {
        Vector3 point, up;  // m; unit normal
        int collider = 0;
    };
    // Two boxes, or a box and a plane (`other` = -1 - index of the plane).
    struct Candidate {
        Pair pair;
        int box = 0;
        int other = 0;
    };

    void bound(std::span<const Collider> colliders, std::span<const Body> bodies, std::span<const Pose> poses,
               double margin, const StepMotions* step, const Awake& awake, std::span<const int> moved,
               Threads* threads);
    void list_shapes(std::span<const Collider> colliders, std::span<const Pose> poses, const StepMotions* step,
                     std::span<const int> moved);
    bool has_same_shapes() const;
    bool uses_grid() const;
    void update_candidates(Threads* threads);
    bool find_left(Threads* threads);
    void find_all_candidates(Threads* threads);
    void find_candidates_of_left(Threads* threads);
    void widen(std::size_t index);
    void add_with_planes(int index, std::vector<Candidate>& found) const;
    void add_if_near(int index, int other, std::vector<Candidate>& found) const;
    bool is_near(const Candidate& candidate) const;
    bool can_move(const Candidate& candidate) const;  // at least one of the two can

    const PairFilter* filter_ = nullptr;
    std::vector<Bounds> bounds_;  // of the finite shapes, current
    std::vector<int> place_;      // in bounds_, by collider; -1 for a plane
    std::vector<Plane> planes_;

    // State when the candidates were found.
    std::vector<Bounds> wide_;  // with the extra reach
    std::vector<Plane> wide_planes_;
    std::vector<Candidate> candidates_;  // in ascending order of the pair
    BoxGrid grid_;                       // of wide_, if there are many
    std::size_t put_again_ = 0;          // boxes re-inserted since the grid was filled

    std::vector<int> looked_at_;  // boxes in the last find_pairs() that may have moved
    std::vector<int> left_;       // boxes that have left their wide box, or have woken
    std::vector<char> has_left_;  // by box
    std::vector<Pair> pairs_;
    Search<Candidate> candidate_search_;
    Search<Pair> pair_search_;
};

}  // namespace pushfactor::engine::collision
