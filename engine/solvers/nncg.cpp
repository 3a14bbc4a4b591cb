// M. Silcowitz-Hansen, S. Niebe, K. Erleben, "A nonsmooth nonlinear conjugate gradient method for interactive
// contact force problems", The Visual Computer 26 (2010). A sweep of paper 7.1.1 over all rows takes the place of a
// gradient step, and conjugate directions after Fletcher and Reeves are built from such steps:
//
//   y' = sweep(y_k)                   r_k = y' - y_k        beta = |r_k|^2 / |r_(k-1)|^2
//   y_(k+1) = y' + beta p_(k-1)       p_k = beta p_(k-1) + r_k                            beta <= 1
//   y_(k+1) = y'                      p_k = 0                          otherwise: restart
//
// Symbols: y forces of the unit rows, r change by a sweep, p direction [all sqrt(kg) m/s] (unit_row.h), beta [1].
//
// Deviations: the method is written in lambda; in y its norms do not depend on the scaling of rows. An
// extrapolation may leave the bounds, so the last iteration makes none: the result is within them.
// The method is not monotone; with tolerances the result is the best iterate that was evaluated. The velocities x
// follow y row by row. Applying the formula of y to x, one update per body, would be cheaper, but then rounding
// errors grow with the square of the iterations (5e-11 m/s after 1000, not 2e-15).
#include "engine/solvers/nncg.h"

#include "engine/solvers/sweep.h"

namespace pushfactor::engine::solvers {

namespace {

class ConjugateSweeps : public Solver {
  public:
    SolveCount solve(const SystemEquation& system, const Island& island, const Termination& termination,
                     Columns& lambda) override {
        return by_columns(rows_, system, island, lambda, [&](UnitRows&) { return solve_column(termination); });
    }
    std::unique_ptr<Solver> another() const override { return std::make_unique<ConjugateSweeps>(); }

  private:
    SolveCount solve_column(const Termination& termination) {
        const bool checked = termination.tolerance_high > 0.0;
        SolveCount count;
        if (checked) start_from_guess(count);

        p_.assign(rows_.rows.size(), 0.0);
        last_length_ = infinity;  // makes the first beta zero, so that p becomes r
        while (count.iterations < termination.iterations) {
            if (count.iterations > 0) extrapolate(count);
            ++count.iterations;
            count.multiply_adds += rows_.pass_work();
            const double change = sweep_and_remember();
            // As in `work_down`, but the last state is always evaluated: it may be worse than an earlier one.
            const bool last = count.iterations == termination.iterations;
            if (!checked || (change > termination.tolerance_low && !last)) continue;
            if (look(count) <= termination.tolerance_low) break;
        }
        if (checked) take_best();
        return count;
    }

    // A warm start outside of its bounds cannot be a solution; its projection can.
    void start_from_guess(SolveCount& count) {
        for (UnitRow& row : rows_.rows) rows_.move(row, row.y);
        best_residual_ = infinity;
        look(count);
    }

    double sweep_and_remember() {
        y_before_.resize(rows_.rows.size());
        for (std::size_t j = 0; j < y_before_.size(); ++j) y_before_[j] = rows_.rows[j].y;
        return sweep(rows_);
    }

    // Extrapolates from the result of a sweep along p: y <- y + beta p,  p <- beta p + r.
    void extrapolate(SolveCount& count) {
        double length = 0.0;  // |r|^2
        for (std::size_t j = 0; j < y_before_.size(); ++j) {
            const double r = rows_.rows[j].y - y_before_[j];
            length += r * r;
        }
        double beta = length / last_length_, share = 1.0;
        last_length_ = length;
        if (!(beta <= 1.0)) beta = share = 0.0;  // restart, also if both are zero or overflow
        for (std::size_t j = 0; j < p_.size(); ++j) {
            UnitRow& row = rows_.rows[j];
            const double y = row.y, step = beta * p_[j];
            p_[j] = step + share * (y - y_before_[j]);
            rows_.set(row, y + step);
        }
        // |r|^2, y and p, and x as in a sweep.
        count.multiply_adds += 15.0 * static_cast<double>(rows_.rows.size());
    }

    // Residual of the current state [m/s]; stores the state if it is the best so far.
    double look(SolveCount& count) {
        count.multiply_adds += rows_.look_work();
        const double residual = rows_.residual();
        if (residual < best_residual_) {
            best_residual_ = residual;
            best_.resize(rows_.rows.size());
            for (std::size_t j = 0; j < best_.size(); ++j) best_[j] = rows_.rows[j].y;
        }
        return residual;
    }

    void take_best() {
        if (!(best_residual_ < infinity)) return;
        for (std::size_t j = 0; j < best_.size(); ++j) rows_.rows[j].y = best_[j];
    }

    UnitRows rows_;
    std::vector<double> y_before_, p_, best_;
    double last_length_ = 0.0;    // |r|^2 of the previous sweep
    double best_residual_ = 0.0;  // m/s
};

}  // namespace

std::unique_ptr<Solver> make_nncg() {
    return std::make_unique<ConjugateSweeps>();
}

}  // namespace pushfactor::engine::solvers
