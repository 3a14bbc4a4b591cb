// Adapter from a method templated on the number of columns to a Solver.
#pragma once

#include "engine/solvers/solver.h"

#include <memory>

namespace pushfactor::engine::solvers {

// `Method<columns>` has a member solve() like that of Solver, for islands with that many columns: one, or two if
// any row has a single-frame correction (8.1).
template <template <int columns> typename Method>
class ByColumns : public Solver {
  public:
    using Solver::solve;
    SolveCount solve(const SystemEquation& system, const Island& island, const Termination& termination,
                     Columns& lambda) override {
        return island.columns == 2 ? two_.solve(system, island, termination, lambda)
                                   : one_.solve(system, island, termination, lambda);
    }

    std::unique_ptr<Solver> another() const override { return std::make_unique<ByColumns>(); }

  private:
    Method<1> one_;
    Method<2> two_;
};

}  // namespace pushfactor::engine::solvers
