// One column of the system in unit rows (unit_row.h), in the form for the exact methods. Internal to the solvers.
//
// Symbols: y forces, x velocities of the bodies [both sqrt(kg) m/s], U the unit axes, r = t - U x with x = U^T y
// the residual of the rows; of soft rows r = t - U x - soft y.
#pragma once

#include "engine/solvers/exact/row_passes.h"
#include "engine/solvers/unit_row.h"
#include "engine/system/system_equation.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pushfactor::engine::solvers {

struct UnitProblem {
    std::vector<UnitRow> rows;  // their y are not read
    std::vector<RowSpan> spans;
    const Jacobian* units = nullptr;  // by row
    std::size_t bodies = 0;
    bool bounds_follow = false;  // some row has a leader
    bool has_discs = false;
    bool has_soft = false;

    void take(const std::vector<UnitRow>& unit_rows) {
        rows = unit_rows;
        units = rows.front().unit;
        spans.clear();
        for (int j = 0; j < static_cast<int>(rows.size()); ++j) {
            const UnitRow& row = rows[static_cast<std::size_t>(j)];
            if (spans.empty() || spans.back().a != row.a || spans.back().b != row.b) {
                spans.push_back({.begin = j, .a = row.a, .b = row.b});
            }
            spans.back().end = j + 1;
        }
    }

    // Multiply-adds of a pass over the rows that only reads, of one that also writes, and of adding all rows to a
    // matrix to be factorised.
    double look_work() const { return look_work(static_cast<double>(rows.size())); }
    double pass_work() const { return 2.0 * look_work(); }
    double assembly_work() const { return assembly_work(static_cast<double>(rows.size()), bounds_follow); }
    static double look_work(double rows) { return 12.0 * rows; }
    static double assembly_work(double rows, bool bounds_follow) { return (bounds_follow ? 180.0 : 108.0) * rows; }
};

using BodyVelocities = std::vector<Vector6>;

// Factor of a row's bounds for the forces `y`.
inline double bound_scale(const UnitRow& row, const std::vector<double>& y) {
    return row.leader < 0 ? 1.0 : y[static_cast<std::size_t>(row.leader)];
}

// `value` clamped to the bounds of a row without a disc, multiplied by `scale`.
inline double clamped(const UnitRow& row, double value, double scale) {
    return std::max(std::min(value, row.high * scale), row.low * scale);
}

// Clamps the force `value[j]` to its bounds for the forces `y`; for the second row of a disc both its forces, for
// the first none.
inline void clamp(const UnitProblem& problem, const std::vector<double>& y, std::size_t j,
                  std::vector<double>& value) {
    const UnitRow& row = problem.rows[j];
    const double scale = bound_scale(row, y);
    if (row.disc == Disc::none) value[j] = clamped(row, value[j], scale);
    if (row.disc != Disc::second) return;
    const double share = share_in_disc(value[j - 1] * value[j - 1] + value[j] * value[j], row.high * scale);
    value[j - 1] *= share;
    value[j] *= share;
}

// Clamps all forces to their bounds; leaders come before their followers.
inline void clamp(const UnitProblem& problem, std::vector<double>& y) {
    for (std::size_t j = 0; j < y.size(); ++j) clamp(problem, y, j, y);
}

inline bool act_on_the_same(const UnitRow& a, const UnitRow& b) {
    return a.a == b.a && a.b == b.b;
}

// Linear combination of the two tangents of a disc.
inline Jacobian between(const UnitRow& first, double share_1, const UnitRow& second, double share_2) {
    return {share_1 * first.unit->a + share_2 * second.unit->a, share_1 * first.unit->b + share_2 * second.unit->b};
}

// v += sum of u_j y_j, for axes u_j of all rows; and for the rows' own axes.
inline void push(const UnitProblem& problem, const Jacobian* units, const std::vector<double>& y,
                 BodyVelocities& v) {
    push_rows(problem.spans.data(), static_cast<int>(problem.spans.size()), units->a.data(), y.data(),
              v.front().data());
}
inline void push(const UnitProblem& problem, const std::vector<double>& y, BodyVelocities& v) {
    push(problem, problem.units, y, v);
}

// u_j . v of all rows.
inline void find_speeds(const UnitProblem& problem, const BodyVelocities& v, std::vector<double>& speeds) {
    speeds.resize(problem.rows.size());
    find_speeds(problem.spans.data(), static_cast<int>(problem.spans.size()), problem.units->a.data(),
                v.front().data(), speeds.data());
}

// Computes x and r.
inline void follow(const UnitProblem& problem, const std::vector<double>& y, BodyVelocities& x,
                   std::vector<double>& r) {
    x.assign(problem.bodies, Vector6::Zero());
    push(problem, y, x);
    find_speeds(problem, x, r);
    for (std::size_t j = 0; j < y.size(); ++j) r[j] = problem.rows[j].t - r[j];
    if (!problem.has_soft) return;
    for (std::size_t j = 0; j < y.size(); ++j) r[j] -= problem.rows[j].soft * y[j];
}

// Change of a force by the natural map: of row `j`, or of both rows of a disc if `j` is its second.
struct Change {
    double of_first = 0.0, of_row = 0.0;

    double squared() const { return of_first * of_first + of_row * of_row; }
};
inline Change natural_change(const UnitProblem& problem, const std::vector<double>& y, const std::vector<double>& r,
                             std::size_t j) {
    const UnitRow& row = problem.rows[j];
    const double scale = bound_scale(row, y);
    if (row.disc == Disc::none) return {0.0, clamped(row, y[j] + r[j], scale) - y[j]};
    if (row.disc == Disc::first) return {};
    const double first = y[j - 1] + r[j - 1], second = y[j] + r[j];
    const double share = share_in_disc(first * first + second * second, row.high * scale);
    return {share * first - y[j - 1], share * second - y[j]};
}

// Natural residual [m/s] of y with this r; NaN if any term is.
inline double residual(const UnitProblem& problem, const std::vector<double>& y, const std::vector<double>& r) {
    double largest = 0.0;
    for (std::size_t j = 0; j < y.size(); ++j) {
        const double change = std::sqrt(natural_change(problem, y, r, j).squared());
        if (std::isnan(change)) return change;
        largest = std::max(largest, problem.rows[j].scale * change);
    }
    return largest;
}

// q = 1/2 |x|^2 + 1/2 soft . y^2 - t . y [J], which the solution minimises: the energy that the forces give the
// bodies beyond what is asked for, less a rounding allowance. During the iteration the residual may be small while
// the forces do more work than zero forces would.
inline double objective(const UnitProblem& problem, const std::vector<double>& y, const BodyVelocities& x) {
    double q = 0.0;
    for (const Vector6& velocity : x) q += 0.5 * velocity.squaredNorm();
    for (std::size_t j = 0; j < y.size(); ++j) {
        const double work = problem.rows[j].t * y[j];
        q -= work + 1e-13 * std::abs(work);
    }
    if (!problem.has_soft) return q;
    for (std::size_t j = 0; j < y.size(); ++j) q += 0.5 * problem.rows[j].soft * y[j] * y[j];
    return q;
}

// The best iterate so far: the one with the smallest residual among those that give the bodies no more energy than
// the first one or zero force.
class BestForces {
  public:
    // Starts with `y`, and its x and r from follow().
    void start(const UnitProblem& problem, const std::vector<double>& y, const BodyVelocities& x,
               const std::vector<double>& r) {
        y_ = y;
        residual_ = solvers::residual(problem, y, r);
        if (!std::isfinite(residual_)) residual_ = infinity;
        allowed_ = std::max(0.0, objective(problem, y, x));
    }

    // Stores `y` if it is the best so far; returns whether it is.
    bool look(const UnitProblem& problem, const std::vector<double>& y, const BodyVelocities& x,
              const std::vector<double>& r) {
        const double now = solvers::residual(problem, y, r);
        // The order of comparisons rejects a non-finite y, whose residual may look small.
        const bool better = now < residual_ && objective(problem, y, x) <= allowed_;
        if (!better) return false;
        y_ = y;
        residual_ = now;
        return true;
    }

    const std::vector<double>& y() const { return y_; }
    double residual() const { return residual_; }  // m/s

  private:
    std::vector<double> y_;
    double residual_ = 0.0;
    double allowed_ = 0.0;  // J
};

}  // namespace pushfactor::engine::solvers
