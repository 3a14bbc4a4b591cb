// M. Silcowitz-Hansen, S. Niebe, K. Erleben, "A nonsmooth nonlinear conjugate gradient method for interactive
// contact force problems", The Visual Computer 26 (2010). A sweep of paper 7.1.1 over all rows takes the place of a
// gradient step, and conjugate directions after Fletcher and Reeves are built from such steps:
//
//   y' = sweep(y_k)                   r_k = y' - y_k        beta = |r_k|^2 / |r_(k-1)|^2
//   y_(k+1) = y' + beta p_(k-1)       p_k = beta p_(k-1) + r_k                            beta <= 1
//   y_(k+1) = y'                      p_k = 0                          otherwise: restart
//
// Symbols: y forces of the unit rows, r change by a sweep, p direction [all sqrt(kg) m/s] (unit_rows.h), beta [1].
//
// Deviations: the method is written in lambda; in y its norms do not depend on the scaling of rows. Each column has
// its own beta. An extrapolation may leave the bounds, so the last iteration makes none: the result is within them.
// The method is not monotone; with tolerances the result is the best iterate that was evaluated. The velocities x
// follow y row by row. Applying the formula of y to x, one update per body, would be cheaper, but then rounding
// errors grow with the square of the iterations (5e-11 m/s after 1000, not 2e-15).
#include "engine/solvers/nncg.h"

#include "engine/solvers/by_columns.h"
#include "engine/solvers/sweep.h"

namespace pushfactor::engine::solvers {

namespace {

template <int columns>
class ConjugateSweeps {
  public:
    SolveCount solve(const SystemEquation& system, const Island& island, const Termination& termination,
                     Columns& lambda) {
        const bool checked = termination.tolerance_high > 0.0;
        rows_.load(system, island, lambda);
        SolveCount count;
        if (checked) start_from_guess(count);

        forget_directions();
        while (count.iterations < termination.iterations) {
            if (count.iterations > 0) extrapolate(count);
            ++count.iterations;
            count.multiply_adds += rows_.pass_work();
            const double change = sweep_and_remember();
            // As in `iterate`, but the last state is always evaluated: it may be worse than an earlier one.
            const bool last = count.iterations == termination.iterations;
            if (!checked || (change > termination.tolerance_low && !last)) continue;
            if (look(count) <= termination.tolerance_low) break;
        }
        if (checked) take_best();
        rows_.store(system, island, lambda);
        return count;
    }

  private:
    using Values = std::array<double, columns>;

    // A warm start outside of its bounds cannot be a solution; its projection can.
    void start_from_guess(SolveCount& count) {
        project();
        best_residual_ = infinity;
        look(count);
    }

    // Clamps every row to its bounds.
    void project() {
        for (auto& row : rows_.rows) {
            for (int c = 0; c < columns; ++c) rows_.move(row, c, row.y[rows_.at(c)]);
        }
    }

    void forget_directions() {
        p_.assign(rows_.rows.size(), Values{});
        // Makes the first beta zero, so that p becomes r.
        last_length_.fill(infinity);
    }

    double sweep_and_remember() {
        y_before_.resize(rows_.rows.size());
        for (std::size_t j = 0; j < y_before_.size(); ++j) y_before_[j] = rows_.rows[j].y;
        return sweep(rows_);
    }

    // Extrapolates from the result of a sweep along p, per column.
    void extrapolate(SolveCount& count) {
        for (int c = 0; c < columns; ++c) {
            const double length = changed_squared(c);
            const double beta = length / last_length_[rows_.at(c)];
            last_length_[rows_.at(c)] = length;
            // Negated, to restart also if both are zero or overflow.
            const bool restart = !(beta <= 1.0);
            go_on(c, restart ? 0.0 : beta, restart ? 0.0 : 1.0);
        }
        // |r|^2, y and p, and x as in a sweep.
        count.multiply_adds += 15.0 * columns * static_cast<double>(rows_.rows.size());
    }

    // |r|^2
    double changed_squared(int c) const {
        double sum = 0.0;
        for (std::size_t j = 0; j < y_before_.size(); ++j) {
            const double r = rows_.rows[j].y[rows_.at(c)] - y_before_[j][rows_.at(c)];
            sum += r * r;
        }
        return sum;
    }

    // y <- y + beta p,  p <- beta p + share r.
    void go_on(int c, double beta, double share) {
        for (std::size_t j = 0; j < p_.size(); ++j) {
            auto& row = rows_.rows[j];
            double& p = p_[j][rows_.at(c)];
            const double y = row.y[rows_.at(c)];
            const double step = beta * p;
            p = step + share * (y - y_before_[j][rows_.at(c)]);
            rows_.set(row, c, y + step);
        }
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

    UnitRows<columns> rows_;
    std::vector<Values> y_before_, p_;
    Values last_length_{};  // |r|^2 of the previous sweep
    std::vector<Values> best_;
    double best_residual_ = 0.0;  // m/s
};

}  // namespace

std::unique_ptr<Solver> make_nncg() {
    return std::make_unique<ByColumns<ConjugateSweeps>>();
}

}  // namespace pushfactor::engine::solvers
