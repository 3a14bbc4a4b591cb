// Which pairs of colliders may touch. Candidates are found for boxes that are somewhat wider than the shapes, and
// serve for as long as a shape stays within its wide box. Only for one that has left it they are found anew, so
// that what moves costs nothing where nothing does.
#pragma once

#include "engine/base/threads.h"
#include "engine/bodies/awake.h"
#include "engine/collision/box_grid.h"
#include "engine/collision/collider.h"
#include "engine/collision/foresight.h"

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
    // All pairs whose bounding boxes come closer than `margin` (a fraction of each shape's size) allows, and the
    // paths of their colliders with `foresight`, in ascending order. Never two colliders of one body, never two
    // that are static or not `awake`: such a row could move nothing. `poses` are those of the bodies. Only the
    // colliders `moved` (ascending) are looked at; the others are where they were in the last call. `threads` share
    // the work; null: one thread.
    std::span<const Pair> find_pairs(std::span<const Collider> colliders, std::span<const Body> bodies,
                                     std::span<const Pose> poses, double margin, const Foresight* foresight,
                                     const Awake& awake, std::span<const int> moved, Threads* threads = nullptr);

    // The same where nothing rests.
    std::span<const Pair> find_pairs(std::span<const Collider> colliders, std::span<const Body> bodies,
                                     std::span<const Pose> poses, double margin,
                                     const Foresight* foresight = nullptr);

    // Puts another box in the place of a finite shape's own, until the next find_pairs().
    void put(int collider, const BoundingBox& box);

    // The pairs with one of the colliders `of` (by collider), with the boxes as they are now. Good until the next
    // call, as those of find_pairs() are.
    std::span<const Pair> find_pairs_of(const std::vector<bool>& of);

  private:
    // The bounding box of one finite shape.
    struct Bounds : BoundingBox {
        double slack = 0.0;  // m, by which the wide box reaches farther
        int collider = 0;
        int body = 0;
        bool idle = false;  // of a static body, or of one at rest
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

    void bound(std::span<const Collider> colliders, std::span<const Body> bodies, std::span<const Pose> poses,
               double margin, const Foresight* foresight, const Awake& awake, std::span<const int> moved,
               Threads* threads);
    void list_shapes(std::span<const Collider> colliders, std::span<const Pose> poses, std::span<const int> moved);
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
    bool can_move(const Candidate& candidate) const;  // one of the two at least

    std::vector<Bounds> bounds_;  // of the finite shapes, as they are
    std::vector<int> place_;      // in bounds_, by collider; -1 for a plane
    std::vector<Plane> planes_;

    // As they were when the candidates were found.
    std::vector<Bounds> wide_;  // with wide reach
    std::vector<Plane> wide_planes_;
    std::vector<Candidate> candidates_;  // in ascending order of the pair
    BoxGrid grid_;                       // of wide_, where there are many
    std::size_t put_again_ = 0;          // boxes, since the grid was filled

    std::vector<int> looked_at_;  // boxes of the last find_pairs() that may have moved
    std::vector<int> left_;       // boxes that have left their wide box, or have woken
    std::vector<char> has_left_;  // by box
    std::vector<Pair> pairs_;
    Search<Candidate> candidate_search_;
    Search<Pair> pair_search_;
};

}  // namespace pushfactor::engine::collision
