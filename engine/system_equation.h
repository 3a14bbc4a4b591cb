// The system equation, paper section 6: everything about one step that a solver may know.
//
//   A lambda = b,   A = J M^-1 J^T,   b = v/dt - J (v1/dt + M^-1 f_ext)          6.2.9
//
// Symbols: J the axes of all rows (6.1.2), M^-1 system inverse mass (6.1.2 in 6.1.3, 1/kg and 1/(kg m^2)),
// v1 system velocity before the step (6.1.1, m/s and rad/s), f_ext external forces (6.1.3, N and N m),
// v push factors (6.1.4, m/s), lambda [N], b [m/s^2], A [1/kg].
//
// Deviations: with the bounds of 5.1 it is not an equation but a box-constrained problem: A lambda - b is zero
// between the bounds, >= 0 at c_min and <= 0 at c_max. b has two columns when some row has a correcting push
// (8.1): column 0 with the whole push, the last column with the lasting part alone; otherwise it has one.
#pragma once

#include "engine/body.h"
#include "engine/constraint_row.h"
#include "engine/math.h"

#include <span>
#include <vector>

namespace pushfactor::engine {

// The block of M^-1 of one body, and a square root of it: M^-1 = M^(-1/2) M^(-1/2)^T.
struct InverseMass {
    double linear = 0.0;                     // 1/kg
    double linear_root = 0.0;                // its root
    Matrix3 angular = Matrix3::Zero();       // 1/(kg m^2), world frame
    Matrix3 angular_root = Matrix3::Zero();  // W with W W^T = angular; W maps body axes to world axes
};

struct SystemEquation {
    double dt = 0.0;                         // s
    std::span<const ConstraintRow> rows;     // J, bounds, guesses
    std::vector<InverseMass> inverse_mass;   // M^-1, one block a body
    std::vector<Vector6> free_acceleration;  // v1/dt + M^-1 f_ext, m/s^2 and rad/s^2, one block a body
    VectorX diagonal;                        // A_jj, 1/kg; 0 for a row that cannot move anything
    VectorX scale;                           // s_j, its root
    VectorX inverse_scale;                   // 1 / s_j, 0 for such a row
    std::vector<Jacobian> unit_axes;         // J M^(-1/2) / s, of unit length; angular parts in body axes
    Columns b;                               // m/s^2, rows x columns

    Eigen::Index row_count() const { return b.rows(); }
    Eigen::Index column_count() const { return b.cols(); }
};

// Writes 6.2.9 for the bodies with their forces and these rows into `system`, whose memory is reused.
// `rows` must outlive its use.
void build_system(std::span<const Body> bodies, std::span<const ConstraintRow> rows, double dt,
                  SystemEquation& system);

// The part of build_system that depends on J and M^-1 alone: `diagonal`, its roots, `unit_axes`.
void weigh_rows(SystemEquation& system);

// M^-1 f for one body: acceleration from force and torque (6.1.3).
Vector6 accelerate(const InverseMass& inverse_mass, const Vector6& force);

// 6.2.1: f_c = J^T lambda for column `column` of `lambda`, one force and torque a body (written to `forces`).
void constraint_forces(const SystemEquation& system, const Columns& lambda, Eigen::Index column,
                       std::vector<Vector6>& forces);

// The bounds [N] of row `row` while column `column` of `lambda` is as it is.
struct Interval {
    double low = 0.0;
    double high = 0.0;
};
Interval bounds_of(const ConstraintRow& row, const Columns& lambda, Eigen::Index column);

// Natural-map residual [m/s]: the largest velocity that a row still gets wrong,
// dt max_j A_jj |lambda_j - clamp(lambda_j - w_j / A_jj)| with w = A lambda - b, over all columns.
double natural_residual(const SystemEquation& system, const Columns& lambda);

}  // namespace pushfactor::engine
