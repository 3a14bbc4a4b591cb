#include "engine/restitution.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine {

PushFactor restitution_sum(const PushFactor& push, const Impact& impact) {
    if (impact.gap > 0.0) return push;
    return {.correcting = push.correcting,
            .lasting = push.lasting + std::max(0.0, -impact.restitution * impact.speed)};
}

PushFactor restitution_larger(const PushFactor& push, const Impact& impact) {
    const double rebound = -impact.restitution * impact.speed;
    const bool meets = impact.gap + (impact.speed + impact.acceleration * impact.dt) * impact.dt <= 0.0;
    if (!meets || rebound <= std::abs(impact.acceleration) * impact.dt) return push;
    const double first = std::max(push.correcting + push.lasting, rebound);
    const double last = std::max(push.lasting, rebound);
    return {.correcting = first - last, .lasting = last};
}

}  // namespace pushfactor::engine
