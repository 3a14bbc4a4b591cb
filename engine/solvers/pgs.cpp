// Projected Gauss-Seidel, paper 7.1.1 row after row, with the sum over the other rows computed through the bodies
// (unit_row.h).
#include "engine/solvers/pgs.h"

#include "engine/solvers/sweep.h"

namespace pushfactor::engine::solvers {

namespace {

class Sweeps : public Solver {
  public:
    SolveCount solve(const SystemEquation& system, const Island& island, const Termination& termination,
                     Columns& lambda) override {
        return iterate(rows_, system, island, termination, lambda, [](UnitRows& rows) { return sweep(rows); });
    }
    std::unique_ptr<Solver> another() const override { return std::make_unique<Sweeps>(); }

  private:
    UnitRows rows_;
};

}  // namespace

std::unique_ptr<Solver> make_pgs() {
    return std::make_unique<Sweeps>();
}

}  // namespace pushfactor::engine::solvers
