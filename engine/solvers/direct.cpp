// The exact answer every time the guess is not good enough (exact_answer.h).
#include "engine/solvers/direct.h"

#include "engine/solvers/by_columns.h"
#include "engine/solvers/exact_answer.h"
#include "engine/solvers/single_row.h"
#include "engine/solvers/sweep.h"

namespace pushfactor::engine::solvers {

namespace {

template <int columns>
class Direct {
  public:
    SolveCount solve(const SystemEquation& system, const Island& island, const Termination& termination,
                     Columns& lambda) {
        if (island.rows == 1) {
            SolveCount single = solve_single_row(system, island, termination, lambda);
            single.exact = single.iterations > 0;
            return single;
        }
        SolveCount count;
        rows_.load(system, island, lambda);
        if (keeps_guess(rows_, termination, count)) return count;
        exact_.take(island);
        exact_.plan();
        exact_.solve(rows_, termination.tolerance_low, termination.iterations, count);
        count.exact = true;
        rows_.store(system, island, lambda);
        return count;
    }

  private:
    UnitRows<columns> rows_;
    ExactAnswer exact_;
};

}  // namespace

std::unique_ptr<Solver> make_direct() {
    return std::make_unique<ByColumns<Direct>>();
}

}  // namespace pushfactor::engine::solvers
