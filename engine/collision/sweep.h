// Fast bodies: what the margin does not see, because a body is past it within one step.
//
// A fast pair touches when its bodies, moving on freely, really meet within the step, and its contact then has the
// normal and the points of that moment; a margin as wide as the path instead would stop bodies by faces that they
// pass ("ghost collisions"). The gap of such a point is the path that is left along the normal, so that its row
// aims at -gap/dt like that of every point that is still apart: the bodies end the step touching.
//
// What a collision of the same step throws is swept with the motion that it is thrown with, once the step is
// solved: when it would meet something that has no rows, the step is solved again with them.
//
// Not from the paper, which has no continuous collision detection.
#pragma once

#include "engine/collision/detector.h"
#include "engine/collision/fast_pairs.h"
#include "engine/collision/swept.h"

#include <deque>
#include <span>
#include <vector>

namespace pushfactor::engine::collision {

class Sweep {
  public:
    struct Step {
        std::span<const Collider> colliders;
        std::span<const Body> bodies;  // with the external forces of the step
        double dt = 0.0;               // s
        const Detection& detection;
    };

    // `touches` as the detector found them, where fast pairs are concerned put right: those that meet in the coming
    // step added or with all the points that take part, and those that only pass each other left out. In ascending
    // order of the pair; good until the next call.
    std::span<const Touch> refine(std::span<const Touch> touches, const Step& step);

    // Whether the last refine() foresaw all that meets when the constraint `forces` act too [N and N m, one a
    // body]. If not, the next one for the same step has what was missing.
    bool foresaw(std::span<const Vector6> forces, const Step& step);

    // The step is over: the next refine() is for another one.
    void forget();

  private:
    // Touches with the bodies and points that they point to.
    struct Found {
        std::vector<Touch> touches;
        std::deque<MeetingBodies> bodies;
        std::deque<std::vector<ContactPoint>> points;

        std::span<const ContactPoint> keep(std::span<const ContactPoint> some) {
            return points.emplace_back(some.begin(), some.end());
        }
        void clear() {
            touches.clear();
            bodies.clear();
            points.clear();
        }
    };

    bool any_fast(const Step& step);
    bool any_thrown(std::span<const Vector6> forces, const Step& step);
    void refine_fast(std::span<const Touch> touches, const Step& step);
    bool add_meeting(const Pair& pair, const Step& step, Found& found) const;
    Moving moving(int collider, const Step& step) const;

    std::vector<bool> fast_;       // by collider
    std::vector<Motion> motions_;  // by body
    FastPairs fast_pairs_;
    Found refined_, unforeseen_;
    std::span<const Touch> known_;  // what the last refine() returned
};

}  // namespace pushfactor::engine::collision
