// Fast bodies: what the margin does not see, because a body is past it within one step.
//
// A fast pair touches when its bodies, moving on freely, really meet within the step, and its contact then has the
// normal and the points of that moment; a margin as wide as the path instead would stop bodies by faces that they
// pass ("ghost collisions"). The gap of such a point is the path that is left along the normal, so that its row
// aims at -gap/dt like that of every point that is still apart: the bodies end the step touching.
//
// So does a pair of slower boxes that are beside each other when the step begins: none of their points face each
// other then, but sliding past each other some of them may meet.
//
// What a collision of the same step throws is swept with the motion that it is thrown with, once the step is
// solved: when it would meet something that has no rows, these come too, and what they act on is solved again. And
// when its own rows turn a body deep into what it touches, the pair gets the points of the end of the step as well.
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

    // `touches` as `detector` found them, where fast pairs are concerned, and those beside each other, put right:
    // those that meet in the coming step added or with all the points that take part, and those that only pass each
    // other left out. In ascending order of the pair; good until the next call.
    std::span<const Touch> refine(std::span<const Touch> touches, const Step& step, Detector& detector);

    // The touches that are missing when the constraint `forces` act too [N and N m, one per body]: of pairs that
    // refine() has not had, or that end the step deeper in each other although it has; of each pair once in a step.
    // Only the bodies that `changed` (one per body) names have got other forces since the last of those calls. In
    // ascending order of the pair; good until the next call, but for the points and bodies that they refer to,
    // which are good until the next refine().
    std::span<const Touch> look(std::span<const Vector6> forces, std::span<const NewForce> changed,
                                const Step& step, Detector& detector);

  private:
    // What touches refer to.
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
    void find_pressed(std::span<const Touch> touches, const Step& step);
    bool any_thrown(std::span<const Vector6> forces, std::span<const NewForce> changed, const Step& step);
    void refine_fast(std::span<const Touch> touches, const Step& step, Detector& detector);
    const Touch* known(const Pair& pair) const;  // of the last refine(), null if there is none
    // How the pair goes on; the touch of one that meets is added to `touches`.
    enum class Outcome { meets, passes, undecided };
    Outcome add_meeting(const Pair& pair, const Step& step, std::vector<Touch>& touches);
    void add_turned(const Touch& first, const Step& step, std::vector<Touch>& touches);
    void keep_bodies(const Meeting& meeting, const Step& step, Touch& touch);
    void keep_points(Manifold& manifold, const Moving& a, const Step& step, Touch& touch);
    Moving moving(int collider, const Step& step) const;

    // Whether the pair is one that rows of the margin's kind would not do for.
    bool is_swept(const Pair& pair, const Step& step) const;

    std::vector<bool> fast_;       // by collider: moves by more than the margin, where something bounces
    std::vector<bool> dangerous_;  // by collider: could go through something, or end deep inside
    std::vector<Vector3> freely_;  // m/s by body, the velocities that forces and touches leave to pressed ones
    FastPairs fast_pairs_;
    Passing passing_;
    Found found_;  // of the step
    std::vector<Touch> refined_;
    std::vector<Touch> unforeseen_;  // of the last look
    std::span<const Touch> known_;   // what the last refine() returned
    std::vector<Pair> seen_;         // of all looks of the step, ascending
};

}  // namespace pushfactor::engine::collision
