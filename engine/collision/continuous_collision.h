// Continuous collision detection: contacts that the solution of a step brings about.
//
// Contacts of bodies that move by themselves are found before the step is solved (meeting.h). Bodies thrown by a
// collision of the same step are swept with their new motion once it is: if they would meet something without rows,
// rows are added and the affected islands are solved again. If its own rows turn a body deep into what it touches,
// the pair also gets the points of the end of the step; solved with them it ends elsewhere, so each look is a step
// of Newton's method.
//
// Not from the paper, which has no continuous collision detection.
#pragma once

#include "engine/collision/seams.h"

#include <span>
#include <vector>

namespace pushfactor::engine::collision {

class ContinuousCollision {
  public:
    // Begins a step with its touches, in ascending order of the pair, which must stay valid until it ends.
    void begin(std::span<const Touch> touches);

    // Touches that are missing once constraint forces act: with `scene.motions` under all forces, of pairs that
    // have none, or that end the step deeper although they have. `forces` [N and N m] are those of the constraints,
    // one per body; only bodies marked in `changed` (one per body) have others than in the last of these calls.
    // `awake`: colliders that are not at rest. Ascending order of the pair; valid until the next call, except for
    // the points, which stay valid until the next begin().
    std::span<const Touch> look(const StepScene& scene, std::span<const Vector6> forces,
                                std::span<const char> changed, std::span<const int> awake, BroadPhase& broad_phase,
                                Threads* threads);

  private:
    bool any_thrown(const StepScene& scene, std::span<const Vector6> forces, std::span<const char> changed,
                    std::span<const int> awake, BroadPhase& broad_phase, Threads* threads);
    const Touch* known(const Pair& pair) const;  // of begin() or an earlier look(); null if there is none
    bool is_missing(const Pair& pair, const StepScene& scene, Manifold& manifold, Touch& touch) const;

    std::vector<char> thrown_;  // by collider
    std::span<const Touch> known_;
    std::vector<Touch> found_;       // the first ones of pairs that look() has found in the step, ascending
    std::vector<Touch> unforeseen_;  // of the last look()
    TouchSearch search_;
    Seams seams_;
};

}  // namespace pushfactor::engine::collision
