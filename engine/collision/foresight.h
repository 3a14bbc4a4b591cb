// Speculative contacts: how far bodies move in a step by themselves. A separated point that the step may close
// takes part: its row aims at -gap/dt and does nothing while the gap stays wider, so that a landing body ends
// the step at the surface. Bodies that are stopped or thrown in the step are handled afterwards
// (continuous_collision.h).
//
// The normals are those of the start of the step, which is accurate enough only for bodies that move by a part
// of their size. Faster ones are swept (continuous_collision.h), and so are those that may bounce, because they
// do not end the step where they touch.
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

// Path per step, as a share of its size, from which on a body could tunnel or end deep inside another.
inline constexpr double dangerous = 0.25;

// The space that a moved body needs in a step.
class Way {
  public:
    Way(const Collider& collider, const Body& body, double dt);

    // Whether it comes within `margin` [m] of a bounded shape of a body that does not move.
    bool meets(const Shape& shape, const Body& body, double margin) const;

  private:
    Vector3 point_, up_;      // of a plane
    Vector3 centre_, reach_;  // of the box around all others, m
    double path_ = 0.0;       // m, of any point
    bool is_plane_;
};

// Whether a moved body's path in a step of `dt` [s] takes it through movable bodies: by more than `dangerous` of
// the size of one that it may meet. Of bodies out of its way the answer does not depend.
bool may_pass_through(const Collider& moved, const Body& body, std::span<const Collider> colliders,
                      std::span<const Body> bodies, double dt);

class Foresight {
  public:
    // Predicts the coming step of `dt` [s] with the external forces of `bodies`. Only the colliders `which` are
    // updated; the others, at rest, keep their values. `threads` share the work; null: one thread.
    void look_ahead(std::span<const Collider> colliders, std::span<const Body> bodies, double dt,
                    std::span<const int> which, Threads* threads = nullptr);
    void look_ahead(std::span<const Collider> colliders, std::span<const Body> bodies, double dt) {
        look_ahead(colliders, bodies, dt, Awake(colliders.size()).members());
    }

    // Upper bound on the path of a point of the collider [m], at most `dangerous` of its size; zero for a
    // collider whose velocity exceeds that, since it is swept. Of a moved body any path of a plane, which nothing
    // passes; of other shapes at most `dangerous` of the smallest body that it may meet.
    double path(int collider) const { return paths_[static_cast<std::size_t>(collider)]; }

    // How much of a gap at `point` along `normal` (from body a to body b) the free motions close [m].
    double closing(int body_a, int body_b, const Vector3& normal, const Vector3& point) const;

    // Upper bound on how much the free motions close any gap between two colliders along `normal` [m].
    double most_closing(const Collider& a, const Collider& b, const Vector3& normal) const;

  private:
    double path_of_step(const Collider& collider) const;
    double path_of_moved(const Collider& collider, const Body& body) const;

    std::span<const Collider> colliders_;
    std::span<const Body> bodies_;
    double dt_ = 0.0;
    std::vector<double> paths_;  // by collider
};

// Upper bound on the path of a point of a moved body's collider in `dt` [s]; infinite for a plane that turns.
double path_of_moved(const Collider& collider, const Motion& motion, double dt);

// Upper bound on the path of a point of `collider` in `dt` [s] with `speed` [m/s] and angular velocity `rate`
// [rad/s] of the body.
double path_of(const Collider& collider, double speed, double rate, double dt);

}  // namespace pushfactor::engine::collision
