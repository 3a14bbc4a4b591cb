// The row with the largest residual.
#pragma once

#include "engine/world.h"

#include <optional>

namespace pushfactor::demos {

// Two bodies of a world by index.
struct BodyPair {
    int a = 0, b = 0;
};

// The bodies of the row with the largest residual (engine::RowResiduals) in the last step of the world, among
// unsolved islands; none without such islands, or if their residuals are zero.
std::optional<BodyPair> worst_unsolved(const engine::World& world);

// The same among the islands whose rows contradict each other.
std::optional<BodyPair> worst_contradicting(const engine::World& world);

}  // namespace pushfactor::demos
