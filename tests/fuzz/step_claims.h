// The claims of judge.h about a single step of the engine.
#pragma once

#include "engine/world.h"

#include <optional>
#include <span>
#include <string>

namespace pushfactor::tests {

// One step seen from outside: the bodies before it, and the world with its rows and forces after it.
struct Step {
    std::span<const engine::Body> before;
    const engine::World& world;
    bool isolated = false;  // nothing outside acts: no gravity, no force, no static body
    bool shifts = false;    // some rows move bodies without giving them the momentum of that motion
    bool swept = false;     // some rows or impacts act where bodies meet later in the step
    bool monotone = false;  // the solver never ends above the q from which it started
};

struct Broken {
    std::string claim;
    std::string what;
};

// The first claim that does not hold.
std::optional<Broken> broken_claim(const Step& step);

// Whether the forces of the last step are within their bounds.
std::optional<Broken> broken_bounds(const engine::World& world);

}  // namespace pushfactor::tests
