// The contact constraint, paper section 5.3: one row per contact point.
//
//   j_c = [-n, -r_a x n, n, r_b x n],   v = beta d / dt (5.3.1),   0 <= lambda < inf
//
// Symbols: n normal, unit length, from body a to body b; r_i offset of the point from the centre of mass of
// body i [m]; d penetration depth [m]; v push factor [m/s]; lambda contact force [N]. World frame.
//
// Deviations: the paper does not say which way n points; from a to b makes lambda >= 0 push the bodies apart.
// Three additions: penetration up to `slop` is not corrected, so that resting contacts remain contacts; a point
// separated by g > 0 (inside the margin) may close that gap within the step but no faster, i.e. v = -g/dt in
// both columns (up to a thousandth of the slop it touches and aims at rest instead of following gaps of
// rounding size); and the simplification for a static body b is used for a static body a as well.
//
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

#include "engine/constraints/constraint_row.h"
#include "engine/constraints/point_jacobian.h"

#include <algorithm>

namespace pushfactor::engine {

// Gap [m] up to which a point counts as touching and its row aims at rest. Closing gaps of rounding size would
// shake bodies that are placed in contact.
inline double touching_gap(double slop) {
    return 1e-3 * slop;
}

// Least corrected penetration beyond the slop, as a share of it: less would keep a second column for nothing.
inline constexpr double pushed_out = 1e-6;

inline PushFactor contact_push(double gap, const Correction& correction, double slop, double dt) {
    if (gap > touching_gap(slop)) return {.correcting = 0.0, .lasting = -gap / dt};
    // A body that has been pushed out to the slop stays there up to the tolerance of the solver.
    const double excess = -gap - slop;
    return correct(correction, excess > pushed_out * slop ? excess : 0.0, dt);
}

// Writes the row into a default-constructed `row`. `gap` and `slop` in metres; `correction` must outlive the row.
inline void write_contact_row(const PairPoint& point, const Vector3& normal, double gap,
                              const Correction& correction, double slop, double dt, ConstraintRow& row) {
    point.place(row, normal);
    row.push = contact_push(gap, correction, slop, dt);
    row.correction = &correction;
    row.bounds.c_min = 0.0;
    row.error = gap > 0.0 && gap <= touching_gap(slop) ? 0.0 : gap;
    row.label = {.kind = RowKind::contact, .point = 0, .gap = gap};
}

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
