// The pairs of colliders that may meet within a step although their margins do not reach each other: at least one
// is so fast that it moves by more than its margin in the step.
#pragma once

#include "engine/collision/broad_phase.h"
#include "engine/motion.h"

#include <span>
#include <vector>

namespace pushfactor::engine::collision {

// How far a point of `collider` comes at most in `dt` [s] with the body's `speed` [m/s] and `rate` of turning
// [rad/s].
double path_of(const Collider& collider, double speed, double rate, double dt);

// How its bodies move in the coming step.
struct Outlook {
    std::span<const Collider> colliders;
    std::span<const Body> bodies;
    std::span<const Motion> motions;  // by body
    double dt = 0.0;                  // s
    double margin = 0.0;              // fraction of each shape's size
};

class FastPairs {
  public:
    // Those with at least one fast collider (`fast`, by collider), in ascending order; good until the next call.
    std::span<const Pair> find(const Outlook& outlook, const std::vector<bool>& fast);

  private:
    // What each collider sweeps, as a box on a body of its own, for the same search as with bodies that rest.
    std::vector<Collider> boxes_;
    std::vector<Body> box_bodies_;
    std::vector<Pose> box_poses_;
    BroadPhase broad_phase_;
    std::vector<Pair> pairs_;
};

}  // namespace pushfactor::engine::collision
