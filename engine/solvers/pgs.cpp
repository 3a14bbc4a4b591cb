// Projected Gauss-Seidel, paper 7.1.1 row after row, with the sum over the other rows taken through the bodies
// (unit_rows.h). Both columns are swept together.
#include "engine/solvers/pgs.h"

#include "engine/solvers/gauss_seidel.h"

namespace pushfactor::engine::solvers {

namespace {

template <int columns>
SolveCount run(UnitRows<columns>& rows, const SystemEquation& system, const Termination& termination,
               Columns& lambda) {
    SolveCount count;
    rows.load(system, lambda);
    if (keeps_guess(rows, termination, count)) return count;
    sweep_until(rows, termination, count);
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
