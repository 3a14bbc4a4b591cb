// Projected Gauss-Seidel, paper 7.1.1 row after row, with the sum over the other rows taken through the bodies
// (unit_rows.h). Both columns are swept together.
#include "engine/solvers/pgs.h"

#include "engine/solvers/sweep.h"

namespace pushfactor::engine::solvers {

namespace {

class Pgs : public Solver {
  public:
    SolveCount solve(const SystemEquation& system, const Termination& termination, Columns& lambda) override {
        return system.column_count() == 2 ? iterate(two_columns_, system, termination, lambda, sweep<2>)
                                          : iterate(one_column_, system, termination, lambda, sweep<1>);
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
