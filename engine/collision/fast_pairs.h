// The pairs of colliders that may meet within a step although their margins do not reach each other: at least one
// is so fast that the sweep has to look (sweep.h). They come from the broad phase of the step, with other boxes for
// what is fast.
#pragma once

#include "engine/bodies/motion.h"
#include "engine/collision/broad_phase.h"
#include "engine/collision/foresight.h"

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
    // Before the first find() of a step.
    void begin(std::size_t colliders);

    // Those with at least one fast collider (`fast`, by collider, each of them `awake`), in ascending order; good
    // until the next call.
    // `broad_phase` has the boxes of the step: around each shape, as far as it comes if it is not fast. It gets
    // other ones for those that are, or have been in this step.
    std::span<const Pair> find(const Outlook& outlook, std::span<const int> awake, const std::vector<bool>& fast,
                               BroadPhase& broad_phase);

    // The same, and the pairs `more` (ascending) among them.
    std::span<const Pair> find(const Outlook& outlook, std::span<const int> awake, const std::vector<bool>& fast,
                               std::span<const Pair> more, BroadPhase& broad_phase);

    // Of a collider of the pairs that were found.
    const Motion& motion_of(int collider) const { return swept_[static_cast<std::size_t>(collider)].motion; }

  private:
    // What a collider moves through: a box around it, whatever its shape.
    struct Swept {
        Motion motion;
        BoundingBox box;
        long search = 0;  // that it is of
    };

    const Swept& sweep(const Outlook& outlook, int collider);

    long step_ = 0, search_ = 0;  // the last ones
    std::vector<long> fast_in_;   // by collider, the last step in which it was fast
    std::vector<Swept> swept_;    // by collider, where it has been asked for
    std::vector<Pair> pairs_, merged_;
};

}  // namespace pushfactor::engine::collision
