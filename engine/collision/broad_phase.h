// Which pairs of colliders may touch: sort and sweep along the axis in which the bodies spread most.
#pragma once

#include "engine/collision/collider.h"

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
    std::span<const Pair> find_pairs(std::span<const Collider> colliders, std::span<const Body> bodies,
                                     double margin);

  private:
    struct Bounds {
        Vector3 low, high;  // m
        int collider = 0;
    };

    void bound(std::span<const Collider> colliders, std::span<const Body> bodies, double margin);
    void pair_with_planes(std::span<const Collider> colliders, std::span<const Body> bodies);
    void sweep(std::span<const Collider> colliders, std::span<const Body> bodies);

    std::vector<Bounds> bounds_;  // of the finite shapes
    std::vector<int> planes_;
    std::vector<Pair> pairs_;
};

}  // namespace pushfactor::engine::collision
