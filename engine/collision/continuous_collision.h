// Continuous collision detection: contacts of fast bodies, which pass the margin within one step.
//
// A fast pair touches if its bodies, moving freely, meet within the step (time of impact); the contact has the
// normal and the points of that moment. A margin as wide as the path would instead stop bodies at faces that
// they pass ("ghost collisions"). The gap of such a point is the remaining path along the normal, so its row
// aims at -gap/dt like that of every separated point: the bodies end the step touching.
//
// Slower boxes that are beside each other at the start of the step are treated the same way: none of their
// points face each other then, but sliding past each other some may meet.
//
// Bodies thrown by a collision of the same step are swept with their new motion once the step is solved: if
// they would meet something without rows, rows are added and the affected islands are solved again. If its own
// rows turn a body deep into what it touches, the pair also gets the points of the end of the step.
//
// Not from the paper, which has no continuous collision detection.
#pragma once

#include "engine/bodies/motion.h"
#include "engine/collision/detector.h"
#include "engine/collision/fast_pairs.h"
#include "engine/collision/passing.h"
#include "engine/collision/time_of_impact.h"

#include <deque>
#include <span>
#include <vector>

namespace pushfactor::engine::collision {

class ContinuousCollision {
  public:
    using Step = Passing::Step;

    // Corrects touches of fast pairs and of pairs beside each other: adds coming contacts, completes manifolds,
    // drops passes. Ascending order of the pair; valid until the next call.
    std::span<const Touch> refine(std::span<const Touch> touches, const Step& step, Detector& detector);

    // Touches that are missing once the constraint `forces` act [N and N m, one per body]: of pairs that
    // refine() did not return, or that end the step deeper although it did; each pair at most once per step.
    // Only bodies marked in `changed` (one per body) have other forces than in the last of these calls.
    // Ascending order of the pair; valid until the next call, except for the referenced points and bodies,
    // which stay valid until the next refine().
    std::span<const Touch> look(std::span<const Vector6> forces, std::span<const NewForce> changed,
                                const Step& step, Detector& detector);

  private:
    // Storage that touches refer to.
    struct Found {
        std::deque<MeetingBodies> bodies;
        std::deque<std::vector<ContactPoint>> points;

        std::span<const ContactPoint> keep(std::span<const ContactPoint> some) {
            return points.emplace_back(some.begin(), some.end());
        }
        void clear() {
            bodies.clear();
            points.clear();
        }
    };

    bool any_fast(std::span<const Touch> touches, const Step& step);
    bool any_moved_fast(const Step& step);
    void find_pressed(std::span<const Touch> touches, const Step& step);
    bool any_thrown(std::span<const Vector6> forces, std::span<const NewForce> changed, const Step& step);
    void refine_fast(std::span<const Touch> touches, const Step& step, Detector& detector);
    const Touch* known(const Pair& pair) const;  // of the last refine(); null if there is none
    // How the pair goes on; a touch is added to `touches` if it meets.
    enum class Outcome { meets, passes, undecided };
    Outcome add_meeting(const Pair& pair, const Step& step, std::vector<Touch>& touches);
    void add_turned(const Touch& first, const Step& step, std::vector<Touch>& touches);
    void keep_bodies(const Meeting& meeting, const Step& step, Touch& touch);
    void keep_points(Manifold& manifold, const Moving& a, const Step& step, Touch& touch);
    Moving moving(int collider, const Step& step) const;

    // Whether rows of the margin are not enough for the pair.
    bool is_swept(const Pair& pair, const Step& step) const;

    std::vector<bool> fast_;  // by collider: moves by more than the margin while something bounces, or is dangerous
    std::vector<bool> dangerous_;  // by collider: could tunnel, or end deep inside
    std::vector<Vector3> freely_;  // m/s by body, velocities of pressed bodies that forces and touches allow
    FastPairs fast_pairs_;
    Passing passing_;
    Found found_;  // of the step
    std::vector<Touch> refined_;
    std::vector<Touch> unforeseen_;  // of the last look()
    std::span<const Touch> known_;   // what the last refine() returned
    std::vector<Pair> seen_;         // of all look() calls of the step, ascending
};

}  // namespace pushfactor::engine::collision
