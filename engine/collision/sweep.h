// Fast bodies: what the margin does not see, because a body is past it within one step.
//
// A fast pair touches when its bodies, moving on freely, really meet within the step, and its contact then has the
// normal and the points of that moment; a margin as wide as the path instead would stop bodies by faces that they
// pass ("ghost collisions"). The gap of such a point is the path that is left along the normal, so that its row
// aims at -gap/dt like that of every point that is still apart: the bodies end the step touching.
//
// Not from the paper, which has no continuous collision detection. Bodies that a collision of the same step makes
// fast are swept from the next step on.
#pragma once

#include "engine/collision/detector.h"
#include "engine/collision/fast_pairs.h"

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

  private:
    void refine_pair(const Pair& pair, const Touch* touch, const Step& step);

    FastPairs fast_pairs_;
    std::vector<Moving> moving_;  // by collider
    std::vector<Touch> touches_;
    std::deque<MeetingBodies> meetings_;  // that touches_ point to
};

}  // namespace pushfactor::engine::collision
