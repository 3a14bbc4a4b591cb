// How far bodies come in a step by themselves. A point that is still apart takes part in the step when that may
// close it: its row aims at -gap/dt and does nothing while the gap is wider ("speculative contacts"), so that what
// lands, lands at the surface. What is stopped or thrown in the step is looked after when that is known (sweep.h).
//
// The normals are those of the start of the step, which is good enough only for bodies that move by a part of their
// size. Faster ones are swept (sweep.h), and so is what may bounce, because it does not end its step where it
// touches.
//
// Not from the paper, which has no continuous collision detection.
#pragma once

#include "engine/base/threads.h"
#include "engine/bodies/awake.h"
#include "engine/bodies/motion.h"
#include "engine/collision/collider.h"

#include <span>
#include <vector>

namespace pushfactor::engine::collision {

// Share of its size from which on a body that moves by so much in a step could go through something, or end deep
// inside.
inline constexpr double dangerous = 0.25;

class Foresight {
  public:
    // For the coming step of `dt` [s], with the external forces of `bodies`. Only the colliders `which` are looked
    // at; the others, which rest, are as they were in the last call. `threads` share the work; null: one thread.
    void look_ahead(std::span<const Collider> colliders, std::span<const Body> bodies, double dt,
                    std::span<const int> which, Threads* threads = nullptr);
    void look_ahead(std::span<const Collider> colliders, std::span<const Body> bodies, double dt) {
        look_ahead(colliders, bodies, dt, Awake(colliders.size()).members());
    }

    // How far a point of the collider comes at most [m], but no more than the dangerous share of its size; zero for
    // one that its velocity takes farther, which is swept.
    double path(int collider) const { return paths_[static_cast<std::size_t>(collider)]; }

    // How much of a gap at `point` along `normal`, which points from body a to body b, the free motions close [m].
    double closing(int body_a, int body_b, const Vector3& normal, const Vector3& point) const;

    // The most that these motions close of any gap between two colliders along `normal` [m].
    double most_closing(const Collider& a, const Collider& b, const Vector3& normal) const;

  private:
    double path_of_step(const Collider& collider) const;

    std::span<const Body> bodies_;
    double dt_ = 0.0;
    std::vector<double> paths_;  // by collider
};

// How far a point of `collider` comes at most in `dt` [s] with the body's `speed` [m/s] and `rate` of turning
// [rad/s].
double path_of(const Collider& collider, double speed, double rate, double dt);

}  // namespace pushfactor::engine::collision
