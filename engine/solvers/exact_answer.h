// The exact answer to a system in unit rows, column by column: changes of the active set, and where those do not
// settle, the interior point method; the columns share the factor while the same rows are clamped. Bounds that
// follow another row (Coulomb friction) are found by a fixed point: solve with the bounds as they are, set them
// anew, until they stay.
#pragma once

#include "engine/solvers/active_set.h"
#include "engine/solvers/interior_point.h"
#include "engine/solvers/structures.h"
#include "engine/solvers/sweep.h"
#include "engine/solvers/unit_rows.h"

namespace pushfactor::engine::solvers {

// Rounds of the fixed point, at most: a settled stack takes 2, a landing up to 20.
inline constexpr int most_bound_rounds = 20;
// Sweeps that are tried after them.
inline constexpr int most_bound_sweeps = 200;
// The residual above which the active set has not settled, and the interior point method takes over: a fraction of
// the largest speed that a row is asked for.
inline constexpr double unsettled_share = 1e-7;
// With fewer factorisations left it would not get anywhere.
inline constexpr int least_for_interior_point = 10;

class ExactAnswer {
  public:
    // Finds out which bodies the rows connect. Comes first.
    void take(const Island& island) { structure_ = &structures_.of(island); }
    int pairs() const { return static_cast<int>(structure_->all_pairs.size()); }  // static partners included
    // Whether several movable bodies are connected without a cycle, so that the factor has no fill-in.
    bool is_tree() const {
        const auto pairs = static_cast<int>(structure_->movable_pairs.size());
        return pairs > 0 && pairs < structure_->movable;
    }

    // Plans the factorisation. Comes second, and costs more where there are many pairs.
    void plan() { structures_.plan(*structure_); }
    double factor_work() const { return structure_->matrix.factor_work(); }  // multiply-adds

    // Improves the forces until the natural residual is at most `tolerance` [m/s] or falls no further, with at most
    // `factorisations` a column. Never leaves them worse than they were.
    template <int columns>
    void solve(UnitRows<columns>& rows, double tolerance, int factorisations, SolveCount& count);

  private:
    template <int columns>
    void sweep_bounds(UnitRows<columns>& rows, double tolerance, SolveCount& count);
    template <int columns>
    void take_column(const UnitRows<columns>& rows, int column);
    void settle(double tolerance, int factorisations, SolveCount& count);
    template <int columns>
    double follow_bounds(const UnitRows<columns>& rows);

    Structures structures_;
    Structure* structure_ = nullptr;  // of the island at hand
    ActiveSet active_set_;
    InteriorPoint interior_;
    UnitProblem problem_;
    std::vector<double> y_;
};

template <int columns>
void ExactAnswer::take_column(const UnitRows<columns>& rows, int column) {
    const std::size_t c = rows.at(column);
    problem_.bodies = rows.velocity.size();
    problem_.rows.resize(rows.rows.size());
    y_.resize(rows.rows.size());
    for (std::size_t j = 0; j < rows.rows.size(); ++j) {
        const auto& row = rows.rows[j];
        problem_.rows[j] = {.a = row.a,
                            .b = row.b,
                            .unit = row.unit,
                            .t = row.t[c],
                            .low = row.low,
                            .high = row.high,
                            .scale = row.scale};
        y_[j] = row.y[c];
    }
    follow_bounds(rows);
}

// Sets the bounds that follow another row to what they are with y as it is. Returns the largest change [m/s].
template <int columns>
double ExactAnswer::follow_bounds(const UnitRows<columns>& rows) {
    double largest = 0.0;
    for (std::size_t j = 0; j < rows.rows.size(); ++j) {
        const auto& row = rows.rows[j];
        if (row.of_row < 0) continue;
        UnitProblem::Row& own = problem_.rows[j];
        const double other = y_[static_cast<std::size_t>(row.of_row)];
        largest = std::max(largest, row.scale * std::abs(row.high * other - own.high));
        own.low = row.low * other;
        own.high = row.high * other;
        y_[j] = std::max(std::min(y_[j], own.high), own.low);
    }
    return largest;
}

// The column of problem_, as it is.
inline void ExactAnswer::settle(double tolerance, int factorisations, SolveCount& count) {
    double reached = active_set_.solve(structure_->matrix, problem_, tolerance, factorisations, y_, count);
    double fastest = 0.0;
    for (const UnitProblem::Row& row : problem_.rows) fastest = std::max(fastest, row.scale * std::abs(row.t));
    const double unsettled = unsettled_share * fastest;
    if (reached <= unsettled) return;
    // The interior point stays a little inside the bounds and takes long to get to rounding. But it soon knows
    // which rows are clamped, and from there the active set gets to the end; if not, a longer way shows more.
    int left = active_set_.left();
    for (const double near : {0.1 * unsettled, 0.0}) {
        if (reached <= tolerance || left < least_for_interior_point) return;
        const int before = count.iterations;
        interior_.solve(structure_->matrix, problem_, std::max(tolerance, near), left, y_, count);
        active_set_.start();
        reached = active_set_.solve(structure_->matrix, problem_, tolerance, left - (count.iterations - before), y_,
                                    count);
        left -= count.iterations - before;
    }
}

template <int columns>
void ExactAnswer::solve(UnitRows<columns>& rows, double tolerance, int factorisations, SolveCount& count) {
    active_set_.start();
    const bool follows =
        std::any_of(rows.rows.begin(), rows.rows.end(), [](const auto& row) { return row.of_row >= 0; });
    for (int c = 0; c < columns; ++c) {
        take_column(rows, c);
        for (int round = 0; round < (follows ? most_bound_rounds : 1); ++round) {
            settle(tolerance, factorisations, count);
            if (!follows || follow_bounds(rows) <= tolerance) break;
        }
        for (std::size_t j = 0; j < y_.size(); ++j) rows.rows[j].y[rows.at(c)] = y_[j];
    }
    rows.follow();
    count.residual = rows.residual();
    count.multiply_adds += rows.look_work();
    if (follows) sweep_bounds(rows, tolerance, count);
}

// Where the fixed point of the bounds goes in circles, sweeps may not, whose bounds follow at once.
template <int columns>
void ExactAnswer::sweep_bounds(UnitRows<columns>& rows, double tolerance, SolveCount& count) {
    if (count.residual <= tolerance) return;
    const auto before = rows.rows;
    double now = count.residual;
    for (int k = 0; k < most_bound_sweeps && now > tolerance; ++k) {
        sweep(rows);
        now = rows.residual();
        count.multiply_adds += rows.pass_work() + rows.look_work();
    }
    if (now < count.residual) {
        count.residual = now;
        return;
    }
    rows.rows = before;
    rows.follow();
}

}  // namespace pushfactor::engine::solvers
