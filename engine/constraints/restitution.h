// Elastic collisions as printed, paper section 8.2: the rebound is part of the push of the contact row.
//
//   v_r = -epsilon j_c v1     8.2.1
//
// Symbols: epsilon coefficient of restitution [1]; v1 velocities before the step, without this step's external
// forces [m/s]; v_r the velocity that the collision leaves along the normal [m/s].
//
// Deviation: v_r is at least zero (for separating bodies the printed value pulls).
//
// 8.2 adds v_r to the push factor; the sum throws too high and gains energy at every bounce, because correction and
// rebound are both meant to separate the bodies. It bounces at the beginning of a step, with the speed before it,
// and all collisions of a step are one. impacts.h has collisions in the order in which they happen instead.
#pragma once

#include "engine/constraints/push_factor.h"

#include <algorithm>

namespace pushfactor::engine {

// One contact point before the step, along its normal; positive is separating.
struct Impact {
    double speed = 0.0;         // j_c v1, m/s
    double acceleration = 0.0;  // j_c M^-1 f_ext, m/s^2
    double gap = 0.0;           // m
    double restitution = 0.0;   // epsilon of the pair
    double dt = 0.0;            // s
};

// Push of the contact row including the collision.
using RestitutionRule = PushFactor (*)(const PushFactor& push, const Impact& impact);

// As in 8.2: v_r is added to both columns of a touching point. A separated point that would meet within the step
// has nothing to correct and aims at v_r alone; one that approaches and bounces later may close its gap: it must
// not be stopped because the gap counts as touching.
inline PushFactor restitution_sum(const PushFactor& push, const Impact& impact) {
    const double rebound = std::max(0.0, -impact.restitution * impact.speed);
    if (impact.gap <= 0.0) return {.correcting = push.correcting, .lasting = push.lasting + rebound};
    if (rebound == 0.0) return push;
    const bool meets = impact.gap + (impact.speed + impact.acceleration * impact.dt) * impact.dt <= 0.0;
    return {.correcting = 0.0, .lasting = meets ? rebound : -impact.gap / impact.dt};
}

}  // namespace pushfactor::engine
