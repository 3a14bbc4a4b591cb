// Elastic collisions, paper section 8.2.
//
//   v_r = -epsilon j_c v1     8.2.1
//
// Symbols: epsilon coefficient of restitution [1]; v1 velocities before the step, without this step's external
// forces [m/s]; v_r the velocity that the collision leaves along the normal [m/s].
//
// Deviations: v_r is at least zero (for separating bodies the printed value pulls). 8.2 adds v_r to the push
// factor; the sum throws higher than it should and gains energy at every bounce, because the correction and the
// rebound are both meant to separate the bodies. Taking the larger of the two keeps the energy. And 8.2 bounces at
// the beginning of a step, with the speed before it; here the bounce is where the bodies meet in their flight.
#pragma once

#include "engine/constraints/push_factor.h"

namespace pushfactor::engine {

// One contact point before the step, along its normal; above zero is separating.
struct Impact {
    double speed = 0.0;         // j_c v1, m/s
    double acceleration = 0.0;  // j_c M^-1 f_ext, m/s^2
    double weight = 0.0;        // m/s^2, >= 0: the larger of what f_ext does to either body
    double gap = 0.0;           // m
    double restitution = 0.0;   // epsilon of the pair
    double dt = 0.0;            // s
    // The impulse turns a body whose moments of inertia differ, so that its energy hangs on its orientation.
    bool turns = false;
};

// What the contact row aims at once the collision is added to it.
struct Rebound {
    PushFactor push;
    bool in_momenta = true;  // false: the row has no force in the column that sets momenta (Bounds::in_momenta)
};
using RestitutionRule = Rebound (*)(const PushFactor& push, const Impact& impact);

// As 8.2 has it: v_r is added to both columns of a point that touches. One that is still apart and would meet
// within the step has nothing to correct and aims at v_r alone.
Rebound restitution_sum(const PushFactor& push, const Impact& impact);

// Each column aims at the larger of its push and the rebound, if the point meets within the step. A rebound slower
// than what the weight makes in one step is none, so that resting bodies rest.
//
// Flight within a step is the parabola through the positions that 3.2.3 makes, with the speed j v1 + a dt/2 at its
// beginning (the momenta belong half a step earlier): the point meets after tau, where gap + v tau + a tau^2/2 = 0,
// leaves with v' = -epsilon (v + a tau) and flies on for the rest of the step. The first column moves it there, the
// last leaves the speed that it has then. Apexes follow epsilon^2 exactly, whatever the phase of the bounce.
//
// Where the impulse turns a body with unequal moments, both columns have to turn it alike, or energy comes and goes
// with the difference. There the point leaves from where it is at the beginning of the step, with the speed that it
// would have at this height on its way up: the same apex, up to two steps early.
//
// Bodies that separate before the step do not resist in the last column: when another collision throws one of them
// back, the two bounce in the next step. In one and the same step the rule of 8.2 would make energy of it.
Rebound restitution_larger(const PushFactor& push, const Impact& impact);

}  // namespace pushfactor::engine
