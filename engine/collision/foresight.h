// How far bodies come in a step by themselves. A point that is still apart takes part in the step when that may
// close it: its row aims at -gap/dt and does nothing while the gap is wider ("speculative contacts"), so that what
// lands, lands at the surface, and what a solve stops has been foreseen by whoever runs into it.
//
// The normals are those of the start of the step, which is good enough only for bodies that move by a part of their
// size. Faster ones are swept (sweep.h), and so is what may bounce, because it does not end its step where it
// touches.
//
// Not from the paper, which has no continuous collision detection.
#pragma once

#include "engine/collision/collider.h"
#include "engine/motion.h"

#include <span>
#include <vector>

namespace pushfactor::engine::collision {

// Share of its size from which on a body that moves by so much in a step could go through something, or end deep
// inside.
inline constexpr double dangerous = 0.25;

// Share of its size by which a body may be thrown into its neighbours by what hits it in the step; who is thrown
// farther than the dangerous share is looked after when that is known (sweep.h).
inline constexpr double thrown = 0.02;

class Foresight {
  public:
    // For the coming step of `dt` [s], with the external forces of `bodies`.
    void look_ahead(std::span<const Collider> colliders, std::span<const Body> bodies, double dt);

    // How far a point of the collider comes at most, or the dangerous share of its size if that is less, and how
    // far it may be thrown [m].
    double path(int collider) const { return paths_[static_cast<std::size_t>(collider)]; }

    // How much of a gap at `point` along `normal`, which points from body a to body b, closes at most [m] while
    // nothing is thrown: either body may be stopped while the other goes on.
    double closing(int body_a, int body_b, const Vector3& normal, const Vector3& point) const;

  private:
    std::span<const Body> bodies_;
    double dt_ = 0.0;
    std::vector<double> paths_;  // by collider
};

// How far a point of `collider` comes at most in `dt` [s] with the body's `speed` [m/s] and `rate` of turning
// [rad/s].
double path_of(const Collider& collider, double speed, double rate, double dt);

}  // namespace pushfactor::engine::collision
