// The choice of four points of a manifold of bodies that hardly move.
#pragma once

#include "engine/collision/manifold.h"

#include <vector>

namespace pushfactor::tests {

// `room` [m]: by which the ends of the manifold may move.
inline void keep_four(engine::collision::Manifold& manifold, double room = 0.02) {
    std::vector<double> gaps;
    for (const auto& point : manifold.points()) gaps.push_back(point.gap);
    keep_carrying({.ends = gaps, .room = room}, engine::Matrix3::Identity(), 4, 4, manifold);
}

}  // namespace pushfactor::tests
