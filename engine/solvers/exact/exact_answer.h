// Exact solution of a system in unit rows, column by column: active set method, and interior point method if that
// fails. Internal to the solvers.
#pragma once

#include "engine/solvers/exact/active_set.h"
#include "engine/solvers/exact/effort.h"
#include "engine/solvers/exact/interior_point.h"
#include "engine/solvers/exact/structures.h"
#include "engine/solvers/unit_rows.h"

namespace pushfactor::engine::solvers {

// Largest speed that a row of the problem asks for without any forces [m/s].
double asked_speed(const UnitProblem& problem);

class ExactAnswer {
  public:
    ExactAnswer() = default;
    ExactAnswer(const ExactAnswer&) = delete;  // structure_ points into structures_
    ExactAnswer& operator=(const ExactAnswer&) = delete;

    // Looks up the connectivity of the island. To be called first.
    void take(const Island& island) { structure_ = &structures_.of(island); }
    int pairs() const { return static_cast<int>(structure_->all_pairs.size()); }  // including static bodies

    // Plans the factorisation unless it takes more than `most_work` multiply-adds. To be called second.
    void plan(double most_work = infinity) { structures_.plan(*structure_, most_work); }

    // Multiply-adds of a factorisation and of what is done with it; may be infinite if that exceeds the plan's
    // limit.
    template <int columns>
    double step_work(const UnitRows<columns>& rows) const {
        return InteriorPoint::step_work(structure_->order, static_cast<double>(rows.rows.size()),
                                        rows.bounds_follow());
    }

    // Improves the forces until the natural residual is at most `tolerance` [m/s], stops falling, or the effort is
    // used up; problems with discs, which converge slowly, until it is at most `will_do` [m/s]. Never makes a
    // column worse. Returns whether all columns reached the tolerance, or rounding; if not, count.contradicts may
    // tell why.
    template <int columns>
    bool solve(UnitRows<columns>& rows, double tolerance, double will_do, Effort& effort, SolveCount& count);

  private:
    template <int columns>
    void take_column(const UnitRows<columns>& rows, int column);
    // Solves the current column.
    bool settle(double tolerance, double will_do, Effort& effort, SolveCount& count);
    bool contradicts();
    void solve_without_contradiction(double tolerance, Effort& effort, SolveCount& count);

    Structures structures_;
    Structure* structure_ = nullptr;  // of the current island
    ActiveSet active_set_;
    InteriorPoint interior_;
    UnitProblem problem_;
    std::vector<double> y_, r_, p_;
    BodyVelocities x_;
};

template <int columns>
void ExactAnswer::take_column(const UnitRows<columns>& rows, int column) {
    const std::size_t c = rows.at(column);
    problem_.bodies = rows.velocity.size();
    problem_.bounds_follow = rows.bounds_follow();
    problem_.has_discs = rows.has_discs();
    problem_.has_soft = rows.has_soft();
    problem_.rows.resize(rows.rows.size());
    y_.resize(rows.rows.size());
    for (std::size_t j = 0; j < rows.rows.size(); ++j) {
        const auto& row = rows.rows[j];
        problem_.rows[j] = {.a = row.a,
                            .b = row.b,
                            .unit = row.unit,
                            .t = row.t[c],
                            .low = row.low[c],
                            .high = row.high[c],
                            .leader = row.of_row,
                            .disc = row.disc,
                            .scale = row.scale,
                            .soft = row.soft};
        y_[j] = row.y[c];
    }
    clamp(problem_, y_);
}

template <int columns>
bool ExactAnswer::solve(UnitRows<columns>& rows, double tolerance, double will_do, Effort& effort,
                        SolveCount& count) {
    active_set_.start();
    bool solved = true;
    for (int c = 0; c < columns; ++c) {
        take_column(rows, c);
        effort.begin_column(columns - c);
        solved = settle(tolerance, will_do, effort, count) && solved;
        for (std::size_t j = 0; j < y_.size(); ++j) rows.rows[j].y[rows.at(c)] = y_[j];
    }
    rows.follow();
    return solved;
}

}  // namespace pushfactor::engine::solvers
