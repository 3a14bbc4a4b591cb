// Penetration depth of the bodies of a state.
#pragma once

#include "engine/bodies/body.h"
#include "engine/collision/collider.h"
#include "engine/collision/detector.h"

#include <span>
#include <vector>

namespace pushfactor::engine {

// Penetration d = -gap over all contact points of the current state.
struct Penetration {
    double max = 0.0;  // m, 0 without contact
    double rms = 0.0;  // m, over the contact points (measure M4, before the division by a length)
    int points = 0;

    // Pairs that overlap by more than `listed` of their size, ascending, and by which share.
    static constexpr double listed = 0.01;
    struct Pair {
        collision::Pair colliders;
        double share = 0.0;
    };
    std::vector<Pair> deep{};
};
Penetration penetration(std::span<const Body> bodies, std::span<const collision::Collider> colliders);

// The same with a detector that is reused from state to state, which is faster if little has moved.
Penetration penetration(std::span<const Body> bodies, std::span<const collision::Collider> colliders,
                        collision::Detector& detector, Threads* threads = nullptr);

// By how much of its size a pair has got deeper from one state to another, at most; from 0 where it was not listed.
double deepening(const Penetration& from, const Penetration& to);

}  // namespace pushfactor::engine
