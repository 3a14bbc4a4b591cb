// Collision detection, paper section 4: colliders -> pairs -> manifolds.
#pragma once

#include "engine/collision/broad_phase.h"
#include "engine/collision/manifold.h"
#include "engine/collision/time_of_impact.h"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace pushfactor::engine::collision {

// Two colliders that touch, nearly touch, or meet within the step (meeting.h).
struct Touch {
    // Not defaulted: a vector would zero-fill the object before its members are set.
    Touch() {}  // NOLINT(modernize-use-equals-default)

    Pair pair;       // collider indices
    int body_a = 0;  // body indices
    int body_b = 0;
    double size = 0.0;         // m, of the smaller movable body; reference length of slop, margin and tolerances
    double friction = 0.0;     // mu of the pair
    double restitution = 0.0;  // epsilon of the pair
    Vector3 normal;            // unit length, world frame, from a to b
    // At least one. Owned by the object that found the touch, valid until its next search.
    std::span<const ContactPoint> points;
    // s, until the bodies meet; the lever arms of the rows belong to that time. 0: they touch, or are near.
    double time = 0.0;
    bool ends_deep = false;  // by the solution so far: gaps are what is left to push out (continuous_collision.h)
    bool doubtful = false;   // also overlaps by no more than `permitted` along another axis (seams.h)
};

// Friction and restitution of pairs of materials, in place of what their colliders would give. Symmetric.
class MaterialPairs {
  public:
    struct Surface {
        std::optional<double> friction{};     // mu >= 0; without: as combined from the colliders
        std::optional<double> restitution{};  // epsilon 0..1
    };

    // For materials 0 .. `materials` - 1.
    explicit MaterialPairs(int materials)
        : materials_(static_cast<std::size_t>(materials)), surfaces_(materials_ * materials_) {}

    void set(int a, int b, const Surface& surface) { at(a, b) = at(b, a) = surface; }

    // Sets what is known of the pair; a negative number is no material.
    [[gnu::noinline]] void put(int a, int b, Touch& touch) const;

    // Whether any pair has a value above zero.
    bool any(std::optional<double> Surface::*what) const;

  private:
    std::size_t index(int a, int b) const {
        return static_cast<std::size_t>(a) * materials_ + static_cast<std::size_t>(b);
    }
    Surface& at(int a, int b) { return surfaces_[index(a, b)]; }

    std::size_t materials_;
    std::vector<Surface> surfaces_;
};

struct Detection {
    double margin = 0.0;     // fraction of the size; points with a smaller gap count
    double permitted = 0.0;  // the same; bodies that overlap by less along an axis count as separated along it
    bool reduce_to_four_points = true;         // of bodies that hardly move on each other; otherwise to eight
    const MaterialPairs* materials = nullptr;  // null: none
};

// Keeps points of touches until it is cleared.
class PointStore {
  public:
    std::span<const ContactPoint> keep(std::span<const ContactPoint> points) {
        if (in_use_ == kept_.size()) kept_.emplace_back();
        kept_[in_use_].assign(points.begin(), points.end());
        return kept_[in_use_++];
    }
    void clear() { in_use_ = 0; }

  private:
    std::vector<std::vector<ContactPoint>> kept_;  // and others for reuse
    std::size_t in_use_ = 0;
};

// What a step detects in.
struct StepScene {
    std::span<const Collider> colliders;
    std::span<const Body> bodies;
    std::span<const Pose> poses;  // by body
    const Detection& detection;
    const StepMotions* motions = nullptr;  // null: contacts of now, all points of their manifolds
    PointStore* kept = nullptr;            // of touches that the detector has not found; until the step ends

    Moving moving(int collider) const {
        const Collider& own = colliders[static_cast<std::size_t>(collider)];
        return {own.shape, poses[static_cast<std::size_t>(own.body)], motions->path_of(own.body)};
    }
    // Centre of the body [m] at `time` [s] of the step.
    Vector3 centre(int body, double time) const {
        return poses[static_cast<std::size_t>(body)].position + time * motions->path_of(body).velocity;
    }
};

// Colliders and bodies that take part in a step if some rest.
struct AwakeColliders {
    const Awake& colliders;
    // Those that may have moved since the last call: the awake and the static ones, or all if the set of awake
    // ones has changed. Ascending.
    std::span<const int> moved_colliders, moved_bodies;
};

// Sets what does not depend on where the bodies are: colliders, bodies, size, friction and restitution.
void name_touch(const Pair& pair, const StepScene& scene, Touch& touch);

// Finds the contact of `pair` into `manifold` and sets the touch but for its points. Returns false if there is
// none.
bool find_touch(const Pair& pair, const StepScene& scene, Manifold& manifold, Touch& touch);

// Searches pairs for touches.
class TouchSearch {
  public:
    // As find_touch(); called concurrently.
    using Find = std::function<bool(const Pair& pair, Manifold& manifold, Touch& touch)>;

    // The touches of those pairs for which `find` returns true, in their order, with the points of their manifolds.
    // Valid until the next call, and may be changed.
    std::vector<Touch>& among(std::span<const Pair> pairs, Threads* threads, const Find& find);

  private:
    // Results of one part of the pairs.
    struct Found {
        std::vector<Touch> touches;
        std::vector<ContactPoint> points;  // of these
    };
    static void search(std::span<const Pair> pairs, const Find& find, Found& found);

    std::vector<Found> found_;  // by part of the pairs
    std::vector<Touch> touches_;
};

class Detector {
  public:
    // All touches in ascending order of the pair; with `motions` also those of pairs that meet within the step.
    // Valid until the next call, and may be changed.
    std::vector<Touch>& detect(std::span<const Collider> colliders, std::span<const Body> bodies,
                               const Detection& detection, const StepMotions* motions = nullptr);

    // The same without touches between colliders that are static or not `awake`.
    std::vector<Touch>& detect(std::span<const Collider> colliders, std::span<const Body> bodies,
                               const Detection& detection, const StepMotions* motions, const AwakeColliders& awake,
                               Threads* threads = nullptr);

    std::span<const Pose> poses() const { return poses_; }  // of the bodies, at the last detect()
    BroadPhase& broad_phase() { return broad_phase_; }      // with the boxes of the last detect()

  private:
    BroadPhase broad_phase_;
    std::vector<Pose> poses_;
    TouchSearch search_;
};

}  // namespace pushfactor::engine::collision
