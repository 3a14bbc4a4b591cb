// The exact answer to a system in unit rows, column by column: changes of the active set, and where those do not
// settle, the interior point method; the columns share the factor while the same rows are clamped. Bounds that
// follow another row (Coulomb friction) are found by a fixed point: solve with the bounds as they are, set them
// anew, until they stay.
#pragma once

#include "engine/solvers/active_set.h"
#include "engine/solvers/interior_point.h"
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
    // Finds out which bodies the rows connect, if they are not those of the last call. Comes first.
    template <int columns>
    void find_pairs(const UnitRows<columns>& rows);
    int pairs() const { return all_pairs_; }      // static partners included
    bool rows_couple() const { return couple_; }  // whether any movable body is in two rows
    int movable_bodies() const { return static_cast<int>(alone_.size()); }

    // Plans the factorisation. Comes second, and costs more where there are many pairs.
    void plan() { matrix_.connect(moves_.size(), pairs_, alone_); }
    double factor_work() const { return matrix_.factor_work(); }  // multiply-adds

    // Improves the forces until the natural residual is at most `tolerance` [m/s] or falls no further, with at most
    // `factorisations` a column. Never leaves them worse than they were.
    template <int columns>
    void solve(UnitRows<columns>& rows, double tolerance, int factorisations, SolveCount& count);

  private:
    // The bodies of a block of rows.
    struct Connection {
        int a = 0, b = 0;
        bool several = false;  // rows
        friend bool operator==(const Connection&, const Connection&) = default;
    };

    void find_pairs();
    template <int columns>
    void sweep_bounds(UnitRows<columns>& rows, double tolerance, SolveCount& count);
    template <int columns>
    void take(const UnitRows<columns>& rows, int column);
    void settle(double tolerance, int factorisations, SolveCount& count);
    template <int columns>
    double follow_bounds(const UnitRows<columns>& rows);

    BodyMatrix matrix_;
    ActiveSet active_set_{matrix_};
    InteriorPoint interior_{matrix_};
    UnitProblem problem_;
    std::vector<double> y_;
    std::vector<Connection> connections_;  // that the following belongs to
    std::vector<char> moves_;              // the same, one a body
    std::vector<Connection> found_;
    std::vector<char> held_;  // movable bodies in a pair
    std::vector<std::pair<int, int>> pairs_;
    std::vector<int> alone_;  // movable bodies, in a pair or not
    int all_pairs_ = 0;
    bool couple_ = false;
};

template <int columns>
void ExactAnswer::find_pairs(const UnitRows<columns>& rows) {
    found_.clear();
    for (const auto& block : rows.blocks) found_.push_back({block.a, block.b, block.count > 1});
    if (found_ == connections_ && moves_ == rows.moves) return;
    connections_.swap(found_);
    moves_ = rows.moves;
    find_pairs();
}

// Of the connections as they are now.
inline void ExactAnswer::find_pairs() {
    pairs_.clear();
    alone_.clear();
    couple_ = false;
    held_.assign(moves_.size(), 0);
    for (const auto& [a, b, several] : connections_) {
        const bool a_moves = moves_[static_cast<std::size_t>(a)], b_moves = moves_[static_cast<std::size_t>(b)];
        for (const auto& [body, body_moves] : {std::pair{a, a_moves}, std::pair{b, b_moves}}) {
            if (!body_moves) continue;
            couple_ = couple_ || several || held_[static_cast<std::size_t>(body)];
            held_[static_cast<std::size_t>(body)] = 1;
        }
        if (a_moves || b_moves) pairs_.emplace_back(std::minmax(a, b));
    }
    std::sort(pairs_.begin(), pairs_.end());
    pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
    all_pairs_ = static_cast<int>(pairs_.size());
    std::erase_if(pairs_, [&](const auto& pair) {
        return !moves_[static_cast<std::size_t>(pair.first)] || !moves_[static_cast<std::size_t>(pair.second)];
    });
    for (std::size_t i = 0; i < held_.size(); ++i) {
        if (held_[i]) alone_.push_back(static_cast<int>(i));
    }
}

template <int columns>
void ExactAnswer::take(const UnitRows<columns>& rows, int column) {
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
    double reached = active_set_.solve(problem_, tolerance, factorisations, y_, count);
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
        interior_.solve(problem_, std::max(tolerance, near), left, y_, count);
        active_set_.start();
        reached = active_set_.solve(problem_, tolerance, left - (count.iterations - before), y_, count);
        left -= count.iterations - before;
    }
}

template <int columns>
void ExactAnswer::solve(UnitRows<columns>& rows, double tolerance, int factorisations, SolveCount& count) {
    active_set_.start();
    const bool follows =
        std::any_of(rows.rows.begin(), rows.rows.end(), [](const auto& row) { return row.of_row >= 0; });
    for (int c = 0; c < columns; ++c) {
        take(rows, c);
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
