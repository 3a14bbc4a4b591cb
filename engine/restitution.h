// Elastic collisions, paper section 8.2.
//
//   v_r = -epsilon j_c v1     8.2.1
//
// Symbols: epsilon coefficient of restitution [1]; v1 velocities before the step, without this step's external
// forces [m/s]; v_r the velocity that the collision leaves along the normal [m/s].
//
// Deviations: v_r is at least zero (for separating bodies the printed value pulls). 8.2 adds v_r to the push
// factor; the sum throws higher than it should and gains energy at every bounce, because the correction and the
// rebound are both meant to separate the bodies. Taking the larger of the two keeps the energy.
#pragma once

#include "engine/push_factor.h"

namespace pushfactor::engine {

// One contact point before the step, along its normal; above zero is separating.
struct Impact {
    double speed = 0.0;         // j_c v1, m/s
    double acceleration = 0.0;  // j_c M^-1 f_ext, m/s^2
    double gap = 0.0;           // m
    double restitution = 0.0;   // epsilon of the pair
    double dt = 0.0;            // s
};

// The push factor of the contact row once the collision is added to it.
using RestitutionRule = PushFactor (*)(const PushFactor& push, const Impact& impact);

// As 8.2 has it: v_r is added to both columns of a point that touches.
PushFactor restitution_sum(const PushFactor& push, const Impact& impact);

// Each column aims at the larger of its push and v_r. A point in the margin bounces only if it would meet within
// the step; and a rebound slower than gravity makes in one step is none, so that resting bodies rest.
PushFactor restitution_larger(const PushFactor& push, const Impact& impact);

}  // namespace pushfactor::engine
