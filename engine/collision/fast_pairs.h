// The pairs of colliders that may meet within a step although their margins do not reach each other: at least one
// is so fast that the sweep has to look (sweep.h).
#pragma once

#include "engine/collision/broad_phase.h"
#include "engine/collision/foresight.h"
#include "engine/motion.h"

#include <span>
#include <vector>

namespace pushfactor::engine::collision {

// How its bodies move in the coming step.
struct Outlook {
    std::span<const Collider> colliders;
    std::span<const Body> bodies;                // with the external forces of the step
    std::span<const Vector6> constraint_forces;  // N and N m, by body; none at all when they are not known yet
    double dt = 0.0;                             // s
    double margin = 0.0;                         // fraction of each shape's size
};

class FastPairs {
  public:
    // Those with at least one fast collider (`fast`, by collider), in ascending order; good until the next call.
    // Looks only at colliders that may come near a fast one.
    std::span<const Pair> find(const Outlook& outlook, const std::vector<bool>& fast);

    // Of a collider of the pairs that were found.
    const Motion& motion_of(int collider) const { return swept_[static_cast<std::size_t>(collider)].motion; }

  private:
    // What a collider moves through: a box around it, whatever its shape.
    struct Swept {
        Motion motion;
        BoundingBox box;
    };
    // Around all fast colliders [m].
    struct Region {
        Vector3 low, high;
    };

    void sweep(const Outlook& outlook, std::size_t collider);
    Region region_of_fast(const Outlook& outlook, const std::vector<bool>& fast);
    bool may_reach(const Region& region, const Outlook& outlook, std::size_t collider) const;
    void add(const Outlook& outlook, std::size_t collider);

    std::vector<Swept> swept_;  // by collider, where it has been asked for

    // The colliders that are looked at, as boxes on bodies of their own, for the same search as with bodies that
    // rest.
    std::vector<int> chosen_;
    std::vector<Collider> boxes_;
    std::vector<Body> box_bodies_;
    std::vector<Pose> box_poses_;
    BroadPhase broad_phase_;
    std::vector<Pair> pairs_;
};

}  // namespace pushfactor::engine::collision
