#include "engine/constraints/restitution.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine {

namespace {

// Per column, the larger of the push and the rebound (`first`, `last`).
Rebound larger(const PushFactor& push, double first, double last, double speed, double since) {
    first = std::max(first, push.correcting + push.lasting);
    last = std::max(last, push.lasting);
    return {.push = {.correcting = first - last, .lasting = last}, .speed = speed, .since = since};
}

// The gap may be closed within the step.
PushFactor closing(const Impact& impact) {
    return {.correcting = 0.0, .lasting = -impact.gap / impact.dt};
}

}  // namespace

Rebound restitution_sum(const PushFactor& push, const Impact& impact) {
    const double rebound = std::max(0.0, -impact.restitution * impact.speed);
    if (impact.gap <= 0.0) return {.push = {.correcting = push.correcting, .lasting = push.lasting + rebound}};
    if (rebound == 0.0) return {.push = push};
    const bool meets = impact.gap + (impact.speed + impact.acceleration * impact.dt) * impact.dt <= 0.0;
    return {.push = meets ? PushFactor{.correcting = 0.0, .lasting = rebound} : closing(impact)};
}

Rebound restitution_larger(const PushFactor& push, const Impact& impact) {
    const double a = impact.acceleration;
    const double dt = impact.dt;
    const double least = std::max(impact.weight * dt, std::sqrt(2.0 * impact.weight * impact.touching));
    if (impact.speed > least) return {.push = push, .in_momenta = false};
    const double gap = std::max(0.0, impact.gap);
    const double before = impact.speed + 0.5 * a * dt;  // at the start of the step (v1 is half a step earlier)
    const double squared = before * before - 2.0 * a * gap;
    const double at_contact = std::sqrt(std::max(0.0, squared));  // approach speed
    if (squared < 0.0 || at_contact - before <= 0.0) return {.push = push};
    const double tau = 2.0 * gap / (at_contact - before);
    const double rebound = impact.restitution * at_contact;
    if (rebound <= least) return {.push = push};
    if (tau >= dt) return {.push = gap > 0.0 ? closing(impact) : push};

    // squared, at the height of the start of the step on the way up
    const double up_here = rebound * rebound + 2.0 * a * gap;
    if (impact.turns && up_here > least * least) {
        const double up = std::sqrt(up_here), speed = up + 0.5 * a * dt;
        return larger(push, speed, speed, up, 0.5 * dt);
    }
    const double rest = dt - tau;
    const double since = rest - 0.5 * dt;
    return larger(push, ((rebound + 0.5 * a * rest) * rest - gap) / dt, rebound + a * since, rebound, since);
}

}  // namespace pushfactor::engine
