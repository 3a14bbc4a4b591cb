// Elastic collisions, paper section 8.2.
//
//   v_r = -epsilon j_c v1     8.2.1
//
// Symbols: epsilon coefficient of restitution [1]; v1 velocities before the step, without this step's external
// forces [m/s]; v_r the velocity that the collision leaves along the normal [m/s].
//
// Deviations: v_r is at least zero (for separating bodies the printed value pulls). 8.2 adds v_r to the push
// factor; the sum throws too high and gains energy at every bounce, because correction and rebound are both
// meant to separate the bodies. Taking the larger of the two conserves the energy. 8.2 bounces at the beginning
// of a step, with the speed before it; here the bounce is where the bodies meet in their flight.
#pragma once

#include "engine/constraints/push_factor.h"

namespace pushfactor::engine {

// One contact point before the step, along its normal; positive is separating.
struct Impact {
    double speed = 0.0;         // j_c v1, m/s
    double acceleration = 0.0;  // j_c M^-1 f_ext, m/s^2
    double weight = 0.0;        // m/s^2, >= 0: larger of the accelerations of both bodies by f_ext
    double gap = 0.0;           // m
    double touching = 0.0;      // m, >= 0: gap up to which the point counts as touching, see contact_row.h
    double restitution = 0.0;   // epsilon of the pair
    double dt = 0.0;            // s
    // The impulse turns a body with unequal moments of inertia, whose energy then depends on its orientation.
    bool turns = false;
};

// Target of the contact row including the collision.
struct Rebound {
    PushFactor push;
    bool in_momenta = true;  // false: the row has no force in the column that sets momenta (Bounds::in_momenta)
    double speed = 0.0;      // of the point just after the impact, m/s; 0 if it does not rebound
    double since = 0.0;      // from the impact to the time of the momenta, s
};
using RestitutionRule = Rebound (*)(const PushFactor& push, const Impact& impact);

// In both rules a separated point that approaches and bounces later, not in this step, may close its gap: it must
// not be stopped because the gap counts as touching.

// As in 8.2: v_r is added to both columns of a touching point. A separated point that would meet within the
// step has nothing to correct and aims at v_r alone.
Rebound restitution_sum(const PushFactor& push, const Impact& impact);

// Each column aims at the larger of its push and the rebound, if the point meets within the step. A rebound is
// ignored, so that resting bodies rest, if it is slower than the velocity gained by the weight in one step, or does
// not rise above the gap that counts as touching: at 1e-3 of the slop that is sqrt(2 weight touching), 0.2 % of
// sqrt(weight size) by default. Without weight everything bounces.
//
// Flight within a step is the parabola through the positions of 3.2.3, with speed j v1 + a dt/2 at its
// beginning (the momenta are half a step earlier): the point meets after tau, where gap + v tau + a tau^2/2 =
// 0, leaves with v' = -epsilon (v + a tau) and flies on for the rest of the step. The first column moves it
// there, the last leaves the speed at that time. Apexes follow epsilon^2 exactly, for any phase of the bounce.
//
// If the impulse turns a body with unequal moments, both columns have to turn it equally, otherwise energy
// comes and goes with the difference. The point then leaves from its position at the beginning of the step,
// with the speed that it would have at this height on its way up: the same apex, up to two steps early.
//
// Bodies that separate before the step do not resist in the last column: if another collision throws one of
// them back, the two bounce in the next step. Within the same step the rule of 8.2 would create energy.
Rebound restitution_larger(const PushFactor& push, const Impact& impact);

}  // namespace pushfactor::engine
