// The system equation, paper section 6: all data of a step that solvers may use.
//
//   A lambda = b,   A = J M^-1 J^T,   b = v/dt - J (v1/dt + M^-1 f_ext)          6.2.9
//
// Symbols: J the axes of all rows (6.1.2), M^-1 system inverse mass (6.1.2 in 6.1.3, 1/kg and 1/(kg m^2)),
// v1 system velocity before the step (6.1.1, m/s and rad/s), f_ext external forces (6.1.3, N and N m),
// v push factors (6.1.4, m/s), lambda [N], b [m/s^2], A [1/kg].
//
// A soft row (a spring) adds its softness s_j to the diagonal: A is J M^-1 J^T + diag(s).
//
// Deviations: with the bounds of 5.1 it is a box-constrained problem (complementarity) instead of an equation: A
// lambda - b is zero between the bounds, >= 0 at c_min and <= 0 at c_max; for the two rows of a disc, bounded by
// their norm, it is zero inside and points against lambda on the circle. b has two columns if any row has a
// correcting push (8.1): column 0 with the whole push, the last column with the lasting part alone; otherwise it
// has one.
//
// Both rows of a disc use the same step size, the largest eigenvalue of their 2 x 2 block of A: with individual
// ones, A_11 and A_22, the disc would become an ellipse and sliding friction would not oppose the sliding.
#pragma once

#include "engine/base/math.h"
#include "engine/base/threads.h"
#include "engine/bodies/body.h"
#include "engine/constraints/constraint_row.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace pushfactor::engine {

// Block of M^-1 of one body, and a square root of it: M^-1 = M^(-1/2) M^(-1/2)^T.
struct InverseMass {
    double linear = 0.0;                     // 1/kg
    double linear_root = 0.0;                // square root of `linear`
    Matrix3 angular = Matrix3::Zero();       // 1/(kg m^2), world frame
    Matrix3 angular_root = Matrix3::Zero();  // W with W W^T = angular; W maps body axes to world axes
};

// Properties of a row that every step reads, in a compact array of their own: a cache line holds four of them,
// while a ConstraintRow takes three lines.
struct RowDigest {
    enum Trait : std::uint16_t {
        follows = 1,          // its bounds follow a row that may have other bodies
        acts_both_ways = 2,   // unbounded in both directions
        rebounds = 4,         // contact that is left at a speed
        drives = 8,           // aims at a speed: friction on a belt or a moved body, or a motor
        not_in_momenta = 16,  // see Bounds
        limited = 32,         // its force has a bound of some kind
        soft = 64,            // has a softness
        joins = 128,          // of a joint
        corrects = 256,       // in one column only, wholly or by its push
        opens = 512,          // a contact, or a bounded distance: no part of a mechanism
    };

    int body_a = 0, body_b = 0;
    RowKind kind = RowKind::contact;
    std::uint16_t traits = 0;

    bool has(Trait trait) const { return (traits & trait) != 0; }
};

inline constexpr std::size_t rows_of_a_part = 1000;  // per thread task

struct SystemEquation {
    double dt = 0.0;                         // s
    std::span<const ConstraintRow> rows;     // J, bounds, warm start
    std::vector<int> awake;                  // bodies that take part, ascending; rows move no others
    std::vector<InverseMass> inverse_mass;   // M^-1, one block per body
    std::vector<Vector6> free_acceleration;  // v1/dt + M^-1 f_ext, m/s^2 and rad/s^2, one block per body
    VectorX diagonal;                // A_jj, 1/kg; 0 for a row that cannot move anything; for discs see above
    Columns b;                       // m/s^2, rows x columns
    std::vector<RowDigest> digests;  // by row
    // m/s, by row: velocity that a moved body gives to it, beside the push (carried.h). Empty if none is moved;
    // not written by build_system().
    std::vector<double> carried;

    // N and N m, by body: moves it in the first column alone, for bodies that were hit within the step (impacts.h).
    // Empty if none was; like `carried` not written by build_system().
    std::vector<Vector6> detours;

    double carried_by(std::size_t row) const { return carried.empty() ? 0.0 : carried[row]; }

    Eigen::Index row_count() const { return b.rows(); }
    Eigen::Index column_count() const { return b.cols(); }
};

// Writes 6.2.9 for the bodies, with their forces, and the rows into `system`, whose memory is reused. `rows` must
// outlive its use. Only bodies in `awake` (ascending) take part, or all; the others count as static.
void build_system(std::span<const Body> bodies, std::span<const int> awake, std::span<const ConstraintRow> rows,
                  double dt, SystemEquation& system, Threads* threads = nullptr);
void build_system(std::span<const Body> bodies, std::span<const ConstraintRow> rows, double dt,
                  SystemEquation& system);

// Extends a built system by rows appended after its own: `rows` are all of them. The bodies must be unchanged.
void extend_system(std::span<const ConstraintRow> rows, SystemEquation& system);

// The part of build_system() that depends only on the rows and M^-1: `diagonal` and `digests`.
void weigh_rows(SystemEquation& system);

// J M^(-1/2) / `scale` of a row, in body axes. With the square root of its A_jj as `scale` it has unit length, at
// most that for a row of a disc. Computed only for solves: kept forces do not need it.
Jacobian unit_axis(const SystemEquation& system, const ConstraintRow& row, double scale);

// A_jj of a row alone, which is none of a disc [1/kg].
double diagonal_of(const SystemEquation& system, const ConstraintRow& row);

// J (v1/dt + M^-1 f_ext) of row `j`, relative to what a moved body gives to it [m/s^2]: b is v/dt less this.
inline double unconstrained(const SystemEquation& system, std::size_t j) {
    const ConstraintRow& row = system.rows[j];
    const double own = row.jacobian.a.dot(system.free_acceleration[static_cast<std::size_t>(row.body_a)]) +
                       row.jacobian.b.dot(system.free_acceleration[static_cast<std::size_t>(row.body_b)]);
    return system.carried.empty() ? own : own - system.carried[j] / system.dt;
}

// J M^-1 f of row `j`, with `forces` by body [N, N m]; m/s^2.
double acceleration_along(const SystemEquation& system, std::size_t j, std::span<const Vector6> forces);

// M^-1 f for one body: acceleration from force and torque (6.1.3).
inline Vector6 accelerate(const InverseMass& inverse_mass, const Vector6& force) {
    return stacked(inverse_mass.linear * force.head<3>(), inverse_mass.angular * force.tail<3>());
}

// 6.2.1: f_c = J^T lambda for column `column` of `lambda`, one force and torque per body (written to `forces`).
void constraint_forces(const SystemEquation& system, const Columns& lambda, Eigen::Index column,
                       std::vector<Vector6>& forces);

// Adds the forces of rows `begin` .. `end` - 1, which act on the same two bodies, to `on_a` and `on_b`.
inline void add_forces_of_rows(const SystemEquation& system, const Columns& lambda, Eigen::Index column,
                               Eigen::Index begin, Eigen::Index end, Vector6& on_a, Vector6& on_b) {
    // Local sums avoid a memory round trip per row.
    Vector6 sum_a = on_a, sum_b = on_b;
    for (Eigen::Index j = begin; j < end; ++j) {
        const ConstraintRow& row = system.rows[static_cast<std::size_t>(j)];
        sum_a += row.jacobian.a * lambda(j, column);
        sum_b += row.jacobian.b * lambda(j, column);
    }
    on_a = sum_a;
    on_b = sum_b;
}

// Bounds [N] of a row for the current values in column `column` of `lambda`; for a row of a disc, those that hold
// while the other row is zero.
struct Interval {
    double low = 0.0;
    double high = 0.0;
};
inline Interval bounds_of(const ConstraintRow& row, const Columns& lambda, Eigen::Index column) {
    if (column > 0 && !row.bounds.in_momenta) return {};
    if (row.bounds.of_row < 0) return {row.bounds.c_min, row.bounds.c_max};
    const double other = lambda(row.bounds.of_row, column);
    return {row.bounds.c_min * other, row.bounds.c_max * other};
}

// Factor that scales a vector of this squared length into the disc.
inline double share_in_disc(double squared_length, double radius) {
    return squared_length > radius * radius ? radius / std::sqrt(squared_length) : 1.0;
}

// Clamps the force of row `j` to its bounds; for the second row of a disc, those of both rows. Returns whether
// anything changed.
inline bool clamp_force(std::span<const ConstraintRow> rows, Eigen::Index j, Eigen::Index column, Columns& lambda) {
    const ConstraintRow& row = rows[static_cast<std::size_t>(j)];
    if (row.bounds.disc == Disc::first) return false;
    const auto [low, high] = bounds_of(row, lambda, column);
    double& force = lambda(j, column);
    if (row.bounds.disc == Disc::none) {
        const double before = force;
        force = std::max(std::min(force, high), low);
        return force != before;
    }
    double& other = lambda(j - 1, column);
    const double share = share_in_disc(force * force + other * other, high);
    if (share == 1.0) return false;
    force *= share;
    other *= share;
    return true;
}

// s_j lambda_j, by which a soft row gives way to its force [m/s^2]; zero for rigid rows.
inline double soft_part(const ConstraintRow& row, const Columns& lambda, Eigen::Index j, Eigen::Index column) {
    return row.softness * lambda(j, column);
}

// Velocity error of rows in one column [m/s], |dt A_jj (lambda_j - clamp(lambda_j - w_j / A_jj))| with w = A lambda
// - b [m/s^2]; infinite for NaN. Rows have to be visited in the order of the step. For a soft row w
// includes soft_part().
class RowResiduals {
  public:
    RowResiduals(const SystemEquation& system, const Columns& lambda, Eigen::Index column)
        : system_(system), lambda_(lambda), column_(column) {}

    // Of row `j`; for the second row of a disc that of both, for the first row zero.
    [[gnu::always_inline]] double next(Eigen::Index j, double w) {
        const ConstraintRow& row = system_.rows[static_cast<std::size_t>(j)];
        const double diagonal = system_.diagonal[j];
        if (diagonal <= 0.0) return 0.0;
        const double force = lambda_(j, column_);
        const double wanted = force - w / diagonal;
        if (row.bounds.disc == Disc::first) {
            wanted_by_first_ = wanted;
            return 0.0;
        }
        const auto [low, high] = bounds_of(row, lambda_, column_);
        if (row.bounds.disc == Disc::none) {
            return in_metres_per_second(diagonal, force - std::min(std::max(wanted, low), high));
        }
        const double share = share_in_disc(wanted_by_first_ * wanted_by_first_ + wanted * wanted, high);
        const double by_first = lambda_(j - 1, column_) - share * wanted_by_first_;
        const double by_second = force - share * wanted;
        return in_metres_per_second(diagonal, std::sqrt(by_first * by_first + by_second * by_second));
    }

  private:
    double in_metres_per_second(double diagonal, double force) const {
        const double miss = system_.dt * diagonal * std::abs(force);
        return std::isnan(miss) ? infinity : miss;
    }

    const SystemEquation& system_;
    const Columns& lambda_;
    Eigen::Index column_;
    double wanted_by_first_ = 0.0;  // N
};

// Natural-map residual [m/s]: the maximum of RowResiduals over all rows and columns. Unlike island_residual() it
// needs no islands, and has no other way to a residual in common with the solvers: a measure for them.
double natural_residual(const SystemEquation& system, const Columns& lambda);

}  // namespace pushfactor::engine
