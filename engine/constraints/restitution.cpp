#include "engine/constraints/restitution.h"

#include <algorithm>

namespace pushfactor::engine {

PushFactor restitution_sum(const PushFactor& push, const Impact& impact) {
    const double rebound = std::max(0.0, -impact.restitution * impact.speed);
    if (impact.gap <= 0.0) return {.correcting = push.correcting, .lasting = push.lasting + rebound};
    if (rebound == 0.0) return push;
    const bool meets = impact.gap + (impact.speed + impact.acceleration * impact.dt) * impact.dt <= 0.0;
    return {.correcting = 0.0, .lasting = meets ? rebound : -impact.gap / impact.dt};
}

}  // namespace pushfactor::engine
