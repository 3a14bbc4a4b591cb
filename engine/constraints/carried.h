// Moved bodies in the system equation. In 6.2.9 J v1 has a part J_s v_s of each static body s. It is zero in the
// paper; for a body with prescribed velocities the rows take it to the other side:
//
//   J_m v_m = v - J_s v_s                    (6.2.5)
//
// so it is part of b, like the push for the speed of a belt, and no source of rows, no solver and no bound has to
// know of it. Forces act in pairs, so J_s need not be known: a row that m is fixed to s by would not see m go
// along with s, and - J_s v_s = J_m t, where t are the velocities of m going along.
//
// Symbols: m movable body, s moved body, x_i position of body i [m], V and w prescribed velocities of s [m/s,
// rad/s], Q = exp(w dt), r = x_m - x_s, p contact point [m], n its normal, v = v_m - V, u the velocity of m at its
// centre that takes m along; together with w it is V + w x (p - x_s) at p, the velocity of the surface there:
//
//   u = V + w x r + alpha e + (1 - alpha) w x v dt / 2
//   e = (Q - 1) r / dt - w x r + w x v' dt / 2,     v' = v - (1 - Q^T) r / dt
//
// The last two terms are second order: the surface turns during the step. alpha is the share with which m goes
// along, see below. What does (alpha = 1, v' = 0) has to be where s is at the end of the step, on the chord: with
// w x r, the velocity at its beginning, it would spiral outwards by w^2 r dt / 2 on a turntable. What does not, as
// a ball that rolls on it, is over another place of s half a step later. That holds across the normal only: the
// normal itself may turn with s (a box), with m or with neither of them (two balls), which a row does not know. So
// a contact row has no such term, and nothing is lifted by the spin of a roller, whose surface stays where it is.
//
//   alpha = max(0, 1 - max(|v'| / |w x r|, |w_m - w| / |w|))
#pragma once

#include "engine/bodies/body.h"
#include "engine/constraints/constraint_row.h"

#include <span>
#include <vector>

namespace pushfactor::engine {

// - J_s v_s [m/s] of a row between two bodies, one of which may be moved, in a step of `dt` [s].
double carried_speed(const ConstraintRow& row, const Body& body_a, const Body& body_b, double dt);

// Appends it for the rows that `speeds` does not have yet.
void carried_speeds(std::span<const Body> bodies, double dt, std::span<const ConstraintRow> rows,
                    std::vector<double>& speeds);

}  // namespace pushfactor::engine
