// The exact answer every time the guess is not good enough (exact_answer.h).
#include "engine/solvers/direct.h"

#include "engine/solvers/exact_answer.h"
#include "engine/solvers/sweep.h"

namespace pushfactor::engine::solvers {

namespace {

class Direct : public Solver {
  public:
    SolveCount solve(const SystemEquation& system, const Termination& termination, Columns& lambda) override {
        return system.column_count() == 2 ? run(two_columns_, system, termination, lambda)
                                          : run(one_column_, system, termination, lambda);
    }

  private:
    template <int columns>
    SolveCount run(UnitRows<columns>& rows, const SystemEquation& system, const Termination& termination,
                   Columns& lambda) {
        SolveCount count;
        rows.load(system, lambda);
        if (keeps_guess(rows, termination, count)) return count;
        exact_.find_pairs(rows);
        exact_.plan();
        exact_.solve(rows, termination.tolerance_low, termination.iterations, count);
        count.exact = true;
        rows.store(system, lambda);
        return count;
    }

    UnitRows<1> one_column_;
    UnitRows<2> two_columns_;
    ExactAnswer exact_;
};

}  // namespace

std::unique_ptr<Solver> make_direct() {
    return std::make_unique<Direct>();
}

}  // namespace pushfactor::engine::solvers
