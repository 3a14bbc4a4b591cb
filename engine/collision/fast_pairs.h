// Pairs of colliders that may meet within a step although their margins do not overlap: at least one is fast
// enough to be swept (continuous_collision.h). They come from the broad phase of the step, with swept boxes for
// fast colliders.
#pragma once

#include "engine/bodies/motion.h"
#include "engine/collision/broad_phase.h"
#include "engine/collision/foresight.h"

#include <span>
#include <vector>

namespace pushfactor::engine::collision {

// Inputs for predicting the motions of the coming step.
struct Outlook {
    std::span<const Collider> colliders;
    std::span<const Body> bodies;                // with the external forces of the step
    std::span<const Vector6> constraint_forces;  // N and N m, by body; empty while unknown
    double dt = 0.0;                             // s
    double margin = 0.0;                         // fraction of each shape's size
};

class FastPairs {
  public:
    // To be called before the first find() of a step.
    void begin(std::size_t colliders);

    // Pairs with at least one fast collider (`fast`, by collider, all of them `awake`), ascending; valid until
    // the next call. `broad_phase` has the boxes of the step, which are wide enough for slow colliders; swept
    // boxes replace those of colliders that are fast or have been in this step.
    std::span<const Pair> find(const Outlook& outlook, std::span<const int> awake, const std::vector<bool>& fast,
                               BroadPhase& broad_phase);

    // The same, merged with the pairs `more` (ascending).
    std::span<const Pair> find(const Outlook& outlook, std::span<const int> awake, const std::vector<bool>& fast,
                               std::span<const Pair> more, BroadPhase& broad_phase);

    // Motion of a collider of the found pairs.
    const Motion& motion_of(int collider) const { return swept_[static_cast<std::size_t>(collider)].motion; }

  private:
    // Motion of a collider and the box that it sweeps.
    struct Swept {
        Motion motion;
        BoundingBox box;
        long search = 0;  // number of the search that computed it
    };

    const Swept& sweep(const Outlook& outlook, int collider);

    long step_ = 0, search_ = 0;  // current numbers
    std::vector<long> fast_in_;   // by collider, the last step in which it was fast
    std::vector<Swept> swept_;    // by collider, if requested
    std::vector<Pair> pairs_, merged_;
};

}  // namespace pushfactor::engine::collision
