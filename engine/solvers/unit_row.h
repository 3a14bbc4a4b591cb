// A row scaled to unit length, as the iterative and exact solvers use it. Internal to the solvers.
//
// With M^(-1/2) = [m^(-1/2), W] (W W^T = I^-1) and s_j = sqrt(A_jj):
//
//   row axis       u_j = M^(-1/2)^T j_c / s_j        unit length, so that A_jj becomes 1
//   force          y_j = lambda_j dt s_j             [sqrt(kg) m/s]
//   right side     t_j = b_j dt / s_j
//   body velocity  x   = sum_j u_j y_j               effect of the forces of all rows on a body
//
// and 7.1.1 reads y_j <- clamp(y_j + t_j - u_j . x), without a division. u_j . x is A lambda, because u_i . u_j =
// A_ij / (s_i s_j).
//
// A soft row has u of length below 1, and its force also moves itself: its error is t_j - u_j . x - soft y_j with
// soft = 1 - |u|^2.
//
// Two rows of a disc have one s, so that their y are bounded by a disc too, and u of length 1 or less. They move
// together: y <- P_disc(y + t - U x), with both errors from the same x (system_equation.h).
#pragma once

#include "engine/constraints/constraint_row.h"

namespace pushfactor::engine::solvers {

struct UnitRow {
    const Jacobian* unit = nullptr;  // u_j
    int a = 0, b = 0;                // bodies, by their numbers in the island
    double y = 0.0, t = 0.0;
    double low = 0.0, high = 0.0;  // bounds of y, or factors of the leader's y
    int leader = -1;               // earlier row that its bounds follow, or -1
    Disc disc = Disc::none;
    double scale = 0.0;  // s_j, m/s of a row per unit of y; 0 for a row that cannot move anything
    double soft = 0.0;   // share of its softness in A_jj; then |u| is below 1
    double keeps = 1.0;  // share of its force that it does not give way to, in sweeps of small steps
};

}  // namespace pushfactor::engine::solvers
