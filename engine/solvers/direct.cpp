// Exact solves (exact_answer.h) up to a bound on their work. Islands beyond that bound are swept, and so are those
// on which the exact method fails: both from its best iterate and from the warm start, whichever gets farther.
#include "engine/solvers/direct.h"

#include "engine/solvers/exact/exact_answer.h"
#include "engine/solvers/single_row.h"
#include "engine/solvers/sweep.h"

namespace pushfactor::engine::solvers {

namespace {

// Largest number of sweeps after a failed exact solve.
constexpr int most_sweeps = 200;
// Largest cost of the exact solves of an island, in multiply-adds per column and step, including re-solves: some
// seconds. Towers and walls of a thousand bodies cost a tenth of it in their first step.
constexpr double most_work_of_a_column = 4e9;
// Expected factorisations per column. An island that would exceed the bound with that many is swept.
constexpr double usual_factorisations = 25.0;

class Direct : public Solver {
  public:
    SolveCount solve(const SystemEquation& system, const Island& island, const Termination& termination,
                     Columns& lambda) override {
        if (island.rows == 1) {
            SolveCount single = solve_single_row(system, island, lambda);
            single.exact = true;
            return single;
        }
        exact_.take(island);
        exact_.plan();
        Effort effort(most_work_of_a_column * island.columns, island.columns, termination.iterations);
        return by_columns(rows_, system, island, lambda,
                          [&](UnitRows&) { return solve_column(termination, effort); });
    }
    std::unique_ptr<Solver> another() const override { return std::make_unique<Direct>(); }

  private:
    SolveCount solve_column(const Termination& termination, Effort& effort) {
        SolveCount count;
        guess_ = rows_.rows;
        effort.begin_column();
        if (usual_factorisations * exact_.step_work(rows_) <= most_work_of_a_column) {
            count.exact = exact_.solve(rows_, termination.tolerance_low, termination.tolerance_low, effort, count);
        }
        // What is within the upper tolerance needs no more, although rounding or the effort has ended it early.
        count.exact = count.exact || rows_.residual() <= termination.tolerance_high;
        if (count.exact || count.contradicts) return count;
        sweep_from(std::vector<UnitRow>(rows_.rows), termination, count);
        if (rows_.residual() > termination.tolerance_low) sweep_from(guess_, termination, count);
        return count;
    }

    // Sweeps from `start` and keeps the result if it is better than the current forces.
    void sweep_from(const std::vector<UnitRow>& start, const Termination& termination, SolveCount& count) {
        const std::vector<UnitRow> before = rows_.rows;
        const double reached = rows_.residual();
        rows_.rows = start;
        rows_.follow();
        Termination sweeps = termination;
        sweeps.iterations = std::min(termination.iterations, most_sweeps);
        const SolveCount swept = work_down(rows_, sweeps, [](UnitRows& rows) { return sweep(rows); });
        count.iterations += swept.iterations;
        count.multiply_adds += swept.multiply_adds + 2.0 * rows_.look_work();
        if (rows_.residual() < reached) return;
        rows_.rows = before;
        rows_.follow();
    }

    UnitRows rows_;
    std::vector<UnitRow> guess_;
    ExactAnswer exact_;
};

}  // namespace

std::unique_ptr<Solver> make_direct() {
    return std::make_unique<Direct>();
}

}  // namespace pushfactor::engine::solvers
