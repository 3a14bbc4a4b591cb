// Collision detection as one thing, paper section 4: colliders -> pairs -> manifolds.
#pragma once

#include "engine/collision/broad_phase.h"
#include "engine/collision/manifold.h"

#include <span>
#include <vector>

namespace pushfactor::engine::collision {

// The bodies of a swept pair with their centres where they will be when they meet (sweep.h), everything else as it
// is at the start of the step. The lever arms of the rows belong to that moment.
struct MeetingBodies {
    Body a, b;
    double time = 0.0;  // s, from the start of the step
};

// Two colliders that touch or nearly do.
struct Touch {
    // Not defaulted: a vector would fill all of it with zeros before its members get their values.
    Touch() {}  // NOLINT(modernize-use-equals-default)

    Pair pair;       // collider indices
    int body_a = 0;  // body indices
    int body_b = 0;
    double size = 0.0;         // m, of the smaller movable body; slop, margin and tolerances are fractions of it
    double friction = 0.0;     // mu of the pair
    double restitution = 0.0;  // epsilon of the pair
    Vector3 normal;            // unit length, world frame, from a to b
    // At least one. They belong to whoever found the touch, and are there until the next search.
    std::span<const ContactPoint> points;
    const MeetingBodies* meeting = nullptr;  // only of a pair that is to meet in the course of the step
    bool doubtful = false;  // overlaps by no more than is permitted along another axis too (passing.h)
};

// Names the pair in `touch`: its colliders, bodies and size.
void name_pair(const Pair& pair, std::span<const Collider> colliders, std::span<const Body> bodies, Touch& touch);

// What the surfaces of the named pair make of a contact: friction and restitution.
void combine_surfaces(std::span<const Collider> colliders, Touch& touch);

struct Detection {
    double margin = 0.0;     // fraction of the size; points with a smaller gap count
    double permitted = 0.0;  // the same; bodies that overlap by less along an axis count as apart along it
    bool reduce_to_four_points = true;  // of a face manifold, which has up to eight
};

// What may move or touch in a step, where bodies are at rest.
struct AwakeColliders {
    const Awake& colliders;
    // What may be elsewhere than at the last look: the awake ones and static ones, or all, where it has changed who
    // that is. Ascending.
    std::span<const int> moved_colliders, moved_bodies;
};

class Detector {
  public:
    // All touches in ascending order of the pair; with `foresight` also points that the step may bring together.
    // The result is good until the next call, and may be changed.
    std::vector<Touch>& detect(std::span<const Collider> colliders, std::span<const Body> bodies,
                               const Detection& detection, const Foresight* foresight = nullptr);

    // The same, but for touches between what is static or not `awake`. `threads` share the work; null: one thread.
    std::vector<Touch>& detect(std::span<const Collider> colliders, std::span<const Body> bodies,
                               const Detection& detection, const Foresight* foresight, const AwakeColliders& awake,
                               Threads* threads = nullptr);

    std::span<const Pose> poses() const { return poses_; }  // of the bodies, at the last detect()
    BroadPhase& broad_phase() { return broad_phase_; }      // with the boxes of the last detect()

    // Pairs without a touch whose motion may bring them together all the same: they are beside each other now, so
    // that no point of one faces the other. In ascending order, of the last detect(); none without foresight.
    std::span<const Pair> beside() const { return beside_; }

  private:
    // What was found for pairs next to each other.
    struct Found {
        std::vector<Touch> touches;  // with as many points as they have, but not with these
        std::vector<ContactPoint> points;
        std::vector<Pair> beside;
        Manifold manifold;                             // of the pair at hand
        std::size_t first_touch = 0, first_point = 0;  // of all
    };
    // What detect() was given.
    struct Scene {
        std::span<const Collider> colliders;
        std::span<const Body> bodies;
        const Detection& detection;
        const Foresight* foresight;
    };

    void find(const Scene& scene, std::span<const Pair> pairs, Found& found) const;
    void put_together(Threads* threads, std::size_t parts);

    BroadPhase broad_phase_;
    std::vector<Pose> poses_;
    std::vector<Touch> touches_;
    std::vector<ContactPoint> points_;  // of all touches, in their order
    std::vector<Pair> beside_;
    std::vector<Found> found_;  // part by part of the pairs
};

}  // namespace pushfactor::engine::collision
