// M. Silcowitz-Hansen, S. Niebe, K. Erleben, "A nonsmooth nonlinear conjugate gradient method for interactive
// contact force problems", The Visual Computer 26 (2010). A sweep of paper 7.1.1 over all rows is taken for a step
// down a gradient, and conjugate directions after Fletcher and Reeves are built from such steps:
//
//   y' = sweep(y_k)                   r_k = y' - y_k        beta = |r_k|^2 / |r_(k-1)|^2
//   y_(k+1) = y' + beta p_(k-1)       p_k = beta p_(k-1) + r_k                            beta <= 1
//   y_(k+1) = y'                      p_k = 0                          otherwise: start again
//
// Symbols: y forces of the unit rows, r what a sweep changed, p direction [all sqrt(kg) m/s] (unit_rows.h), beta
// [1].
//
// Deviations: the method is written in lambda; in y its lengths do not depend on how a row is scaled. Each column
// has its own beta. A step beyond a sweep may leave the bounds, so the last iteration makes none: answers lie
// within them. The method is not monotone; with tolerances on, the answer is the best of all that were looked at.
// The velocities x follow y row by row. They could follow by the formula of y itself, one step a body, which is
// cheaper; but then rounding grows with the square of the iterations (5e-11 m/s after 1000, not 2e-15).
#include "engine/solvers/nncg.h"

#include "engine/solvers/by_columns.h"
#include "engine/solvers/sweep.h"

#include <limits>

namespace pushfactor::engine::solvers {

namespace {

// The method for systems of `columns` columns.
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
            // As in `iterate`, but the last state is always looked at: it may be worse than an earlier one.
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

    // What lies outside of its bounds could not be an answer, what the bounds make of it can.
    void start_from_guess(SolveCount& count) {
        project();
        best_residual_ = std::numeric_limits<double>::infinity();
        look(count);
    }

    // Puts every row within its bounds.
    void project() {
        for (auto& row : rows_.rows) {
            for (int c = 0; c < columns; ++c) rows_.move(row, c, row.y[rows_.at(c)]);
        }
    }

    void forget_directions() {
        p_.assign(rows_.rows.size(), Values{});
        // Makes the first beta zero: nothing to go on with, and p becomes r.
        last_length_.fill(std::numeric_limits<double>::infinity());
    }

    double sweep_and_remember() {
        y_before_.resize(rows_.rows.size());
        for (std::size_t j = 0; j < y_before_.size(); ++j) y_before_[j] = rows_.rows[j].y;
        return sweep(rows_);
    }

    // Goes on from the end of a sweep along p, in each column.
    void extrapolate(SolveCount& count) {
        for (int c = 0; c < columns; ++c) {
            const double length = changed_squared(c);
            const double beta = length / last_length_[rows_.at(c)];
            last_length_[rows_.at(c)] = length;
            // Also when both are zero, or overflow.
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

    // The residual of the state as it is [m/s], remembered when it is the smallest so far.
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
        if (!(best_residual_ < std::numeric_limits<double>::infinity())) return;
        for (std::size_t j = 0; j < best_.size(); ++j) rows_.rows[j].y = best_[j];
    }

    UnitRows<columns> rows_;
    std::vector<Values> y_before_, p_;
    Values last_length_{};  // |r|^2 of the sweep before
    std::vector<Values> best_;
    double best_residual_ = 0.0;  // m/s
};

}  // namespace

std::unique_ptr<Solver> make_nncg() {
    return std::make_unique<ByColumns<ConjugateSweeps>>();
}

}  // namespace pushfactor::engine::solvers
