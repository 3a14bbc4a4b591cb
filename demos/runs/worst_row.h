// Whom a solve has failed: the row that it got most wrong.
#pragma once

#include "engine/world.h"

#include <optional>

namespace pushfactor::demos {

// Two bodies of a world, by their places in it.
struct BodyPair {
    int a = 0, b = 0;
};

// The bodies of the row with the largest residual (engine::RowResiduals) in the last step of the world, among the
// islands that it left unsolved; none without those, or when no row of them misses anything.
std::optional<BodyPair> worst_unsolved(const engine::World& world);

// The same among the islands whose rows contradict each other.
std::optional<BodyPair> worst_contradicting(const engine::World& world);

}  // namespace pushfactor::demos
