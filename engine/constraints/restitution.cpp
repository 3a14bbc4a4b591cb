#include "engine/constraints/restitution.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine {

namespace {

// Of the push and of what a bounce wants in the first and in the last column.
Rebound larger(const PushFactor& push, double first, double last) {
    first = std::max(first, push.correcting + push.lasting);
    last = std::max(last, push.lasting);
    return {.push = {.correcting = first - last, .lasting = last}};
}

}  // namespace

Rebound restitution_sum(const PushFactor& push, const Impact& impact) {
    const double rebound = std::max(0.0, -impact.restitution * impact.speed);
    if (impact.gap <= 0.0) return {.push = {.correcting = push.correcting, .lasting = push.lasting + rebound}};
    const bool meets = impact.gap + (impact.speed + impact.acceleration * impact.dt) * impact.dt <= 0.0;
    return {.push = meets && rebound > 0.0 ? PushFactor{.correcting = 0.0, .lasting = rebound} : push};
}

Rebound restitution_larger(const PushFactor& push, const Impact& impact) {
    const double a = impact.acceleration;
    const double dt = impact.dt;
    const double least = impact.weight * dt;
    if (impact.speed > least) return {.push = push, .in_momenta = false};
    const double gap = std::max(0.0, impact.gap);
    const double before = impact.speed + 0.5 * a * dt;  // at the start of the step
    const double squared = before * before - 2.0 * a * gap;
    const double at_contact = std::sqrt(std::max(0.0, squared));  // downwards
    if (squared < 0.0 || at_contact - before <= 0.0) return {.push = push};
    const double tau = 2.0 * gap / (at_contact - before);
    const double rebound = impact.restitution * at_contact;
    if (tau >= dt || rebound <= least) return {.push = push};

    const double up_here = rebound * rebound + 2.0 * a * gap;  // squared, on the way up
    if (impact.turns && up_here > least * least) {
        const double speed = std::sqrt(up_here) + 0.5 * a * dt;
        return larger(push, speed, speed);
    }
    const double rest = dt - tau;
    return larger(push, ((rebound + 0.5 * a * rest) * rest - gap) / dt, rebound + a * (rest - 0.5 * dt));
}

}  // namespace pushfactor::engine
