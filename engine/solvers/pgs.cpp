// Projected Gauss-Seidel, paper 7.1.1 row after row, with the sum over the other rows taken through the bodies
// (unit_rows.h). Both columns are swept together.
#include "engine/solvers/pgs.h"

#include "engine/solvers/unit_rows.h"

namespace pushfactor::engine::solvers {

namespace {

// One iteration. Returns the largest change of a row's velocity [m/s].
template <int columns>
double sweep(UnitRows<columns>& system) {
    double largest = 0.0;
    for (auto& row : system.rows) {
        for (int c = 0; c < columns; ++c) {
            const double y = row.y[system.at(c)] + system.error(row, c);
            const double change = system.set(row, c, system.clamped(row, c, y));
            largest = std::max(largest, row.scale * std::abs(change));
        }
    }
    return largest;
}

template <int columns>
SolveCount run(UnitRows<columns>& rows, const SystemEquation& system, const Termination& termination,
               Columns& lambda) {
    const bool checked = termination.tolerance_high > 0.0;
    rows.load(system, lambda);
    SolveCount count;
    if (checked) {
        count.multiply_adds += rows.look_work();
        if (rows.residual() <= termination.tolerance_high) return count;
    }
    while (count.iterations < termination.iterations) {
        ++count.iterations;
        count.multiply_adds += rows.pass_work();
        const double change = sweep(rows);
        // The change bounds nothing, but while it is large the residual need not be looked at.
        if (!checked || change > termination.tolerance_low) continue;
        count.multiply_adds += rows.look_work();
        if (rows.residual() <= termination.tolerance_low) break;
    }
    rows.store(system, lambda);
    return count;
}

class Pgs : public Solver {
  public:
    SolveCount solve(const SystemEquation& system, const Termination& termination, Columns& lambda) override {
        return system.column_count() == 2 ? run(two_columns_, system, termination, lambda)
                                          : run(one_column_, system, termination, lambda);
    }

  private:
    UnitRows<1> one_column_;
    UnitRows<2> two_columns_;
};

}  // namespace

std::unique_ptr<Solver> make_pgs() {
    return std::make_unique<Pgs>();
}

}  // namespace pushfactor::engine::solvers
