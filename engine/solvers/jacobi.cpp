// The Jacobi method, paper 7.1.1 for all rows at once: "uses the newly calculated lambdas only after the iteration
// is finished" (7.1). In the form of unit_row.h:
//
//   y_j <- clamp(y_j + w (t_j - u_j . x))     with y and x of the last iteration on the right
//
// Symbols: y forces, t right sides [sqrt(kg) m/s], x body velocities [sqrt(kg) m/s], u row axes, w weight [1].
//
// Deviations: the paper has w = 1, which converges only while the largest eigenvalue of A, scaled to A_jj = 1, is
// below 2. It is 3.6 for one box on four points and 6 in a stack of them, where the paper's form cycles between the
// bounds, farther off than without any force. With w = 0.3 the limit is 6.7: stacks on four points converge slowly;
// on eight points (7.0 and more) they do not, they cycle between the bounds; and rows without bounds, such as seven
// equal bars between two bodies, diverge. A bound that follows another row uses that row's y of the last iteration.
#include "engine/solvers/jacobi.h"

#include "engine/solvers/sweep.h"

namespace pushfactor::engine::solvers {

namespace {

class SimultaneousRows : public Solver {
  public:
    SolveCount solve(const SystemEquation& system, const Island& island, const Termination& termination,
                     Columns& lambda) override {
        return iterate(rows_, system, island, termination, lambda, [this](UnitRows&) { return pass(); });
    }
    std::unique_ptr<Solver> another() const override { return std::make_unique<SimultaneousRows>(); }

  private:
    // One iteration. Returns the largest change of a row's velocity [m/s].
    double pass() {
        next_.resize(rows_.rows.size());
        for (std::size_t j = 0; j < next_.size(); ++j) {
            const UnitRow& row = rows_.rows[j];
            next_[j] = row.y + jacobi_weight * rows_.error(row);
            if (row.disc == Disc::none) next_[j] = rows_.clamped(row, next_[j]);
            if (row.disc == Disc::second) rows_.put_in_disc(row, next_[j - 1], next_[j]);
        }
        double largest = 0.0;
        for (std::size_t j = 0; j < next_.size(); ++j) {
            UnitRow& row = rows_.rows[j];
            largest = std::max(largest, row.scale * std::abs(rows_.set(row, next_[j])));
        }
        return largest;
    }

    UnitRows rows_;
    std::vector<double> next_;
};

}  // namespace

std::unique_ptr<Solver> make_jacobi() {
    return std::make_unique<SimultaneousRows>();
}

}  // namespace pushfactor::engine::solvers
