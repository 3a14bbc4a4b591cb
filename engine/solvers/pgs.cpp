// Projected Gauss-Seidel, paper 7.1.1 row after row, with the sum over the other rows computed through the bodies
// (unit_rows.h). Both columns are swept together.
#include "engine/solvers/pgs.h"

#include "engine/solvers/by_columns.h"
#include "engine/solvers/sweep.h"

namespace pushfactor::engine::solvers {

namespace {

template <int columns>
class Sweeps {
  public:
    SolveCount solve(const SystemEquation& system, const Island& island, const Termination& termination,
                     Columns& lambda) {
        return iterate(rows_, system, island, termination, lambda, sweep<columns>);
    }

  private:
    UnitRows<columns> rows_;
};

}  // namespace

std::unique_ptr<Solver> make_pgs() {
    return std::make_unique<ByColumns<Sweeps>>();
}

}  // namespace pushfactor::engine::solvers
