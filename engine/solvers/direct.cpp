// Exact solves (exact_answer.h) up to a bound on their work. Islands beyond that bound are swept, and so are those
// on which the exact method fails: both from its best iterate and from the warm start, whichever gets farther.
#include "engine/solvers/direct.h"

#include "engine/solvers/by_columns.h"
#include "engine/solvers/exact/exact_answer.h"
#include "engine/solvers/single_row.h"
#include "engine/solvers/sweep.h"

namespace pushfactor::engine::solvers {

namespace {

// Largest number of sweeps after a failed exact solve.
constexpr int most_sweeps = 200;

template <int columns>
class Direct {
  public:
    SolveCount solve(const SystemEquation& system, const Island& island, const Termination& termination,
                     Columns& lambda) {
        if (island.rows == 1) {
            SolveCount single = solve_single_row(system, island, lambda);
            single.exact = true;
            return single;
        }
        SolveCount count;
        rows_.load(system, island, lambda);
        guess_ = rows_.rows;
        exact_.take(island);
        exact_.plan();
        const double most = most_work_of_a_column * columns;
        if (usual_factorisations * columns * exact_.step_work(rows_) <= most) {
            Effort effort(most, termination.iterations);
            count.exact = exact_.solve(rows_, termination.tolerance_low, termination.tolerance_low, effort, count);
        }
        // What is within the upper tolerance needs no more, although rounding or the effort has ended it early.
        count.exact = count.exact || rows_.residual() <= termination.tolerance_high;
        if (!count.exact && !count.contradicts) {
            sweep_from(Rows(rows_.rows), termination, count);
            if (rows_.residual() > termination.tolerance_low) sweep_from(guess_, termination, count);
        }
        rows_.store(system, island, lambda);
        return count;
    }

  private:
    using Rows = std::vector<typename UnitRows<columns>::Row>;

    // Sweeps from `start` and keeps the result if it is better than the current forces.
    void sweep_from(const Rows& start, const Termination& termination, SolveCount& count) {
        const Rows before = rows_.rows;
        const double reached = rows_.residual();
        rows_.rows = start;
        rows_.follow();
        Termination sweeps = termination;
        sweeps.iterations = std::min(termination.iterations, most_sweeps);
        work_down(rows_, sweeps, count, sweep<columns>);
        count.multiply_adds += 2.0 * rows_.look_work();
        if (rows_.residual() < reached) return;
        rows_.rows = before;
        rows_.follow();
    }

    UnitRows<columns> rows_;
    Rows guess_;
    ExactAnswer exact_;
};

}  // namespace

std::unique_ptr<Solver> make_direct() {
    return std::make_unique<ByColumns<Direct>>();
}

}  // namespace pushfactor::engine::solvers
