// The pairs of colliders that may meet within a step although their margins do not reach each other: at least one
// is so fast that it moves by more than its margin in the step.
#pragma once

#include "engine/collision/broad_phase.h"
#include "engine/collision/swept.h"

#include <span>
#include <vector>

namespace pushfactor::engine::collision {

class FastPairs {
  public:
    // In ascending order; `margin` is a fraction of each shape's size. When no body is fast, a look at each is all
    // that is done. The result is good until the next call.
    std::span<const Pair> find(std::span<const Collider> colliders, std::span<const Body> bodies, double dt,
                               double margin);

  private:
    std::vector<bool> fast_;  // by collider
    // What each collider sweeps, as a box on a body of its own, for the same search as with bodies that rest.
    std::vector<Collider> boxes_;
    std::vector<Body> box_bodies_;
    BroadPhase broad_phase_;
    std::vector<Pair> pairs_;
};

// How the body moves in the coming `dt` [s] when nothing stops it.
Motion free_motion(const Body& body, double dt);

}  // namespace pushfactor::engine::collision
