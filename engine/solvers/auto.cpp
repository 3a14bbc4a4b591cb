// The exact solution where it is worth its cost, else sweeps from the guess.
//
// Sweeps converge slowly where a force has to travel far (stacks, chains, large mass ratios). Exactly there the
// bodies are connected like a chain: the matrix of the exact method has little fill-in, and a factorisation costs
// about as much as a few sweeps. In heaps it is the other way round. What an exact solution is worth is known to
// the caller (Termination::worth), and what a factorisation costs is known before it is made, from its plan; so the
// rule depends on structure and guess, never on earlier steps or the clock.
#include "engine/solvers/auto.h"

#include "engine/solvers/exact/exact_answer.h"
#include "engine/solvers/single_row.h"
#include "engine/solvers/sweep.h"

#include <algorithm>

namespace pushfactor::engine::solvers {

namespace {

// Least multiply-adds of a factorisation per pair of bodies: one block.
constexpr double work_of_a_pair = 216.0;

class Auto : public Solver {
  public:
    SolveCount solve(const SystemEquation& system, const Island& island, const Termination& termination,
                     Columns& lambda) override {
        if (island.rows == 1) return solve_single_row(system, island, lambda);
        const double of_one = termination.worth / (termination.factorisations * island.columns);
        bool may_be_worth = plans(island, of_one);
        if (!may_be_worth && termination.iterations == 0) return {};
        Effort effort(termination.worth, island.columns);
        return by_columns(rows_, system, island, lambda, [&](UnitRows&) {
            SolveCount count;
            if (may_be_worth && solve_exactly(termination, of_one, effort, count)) return count;
            if (termination.iterations == 0) may_be_worth = false;  // no other column will do either
            const SolveCount swept = work_down(rows_, termination, [](UnitRows& rows) { return sweep(rows); });
            count.iterations += swept.iterations;
            count.multiply_adds += swept.multiply_adds;
            return count;
        });
    }
    std::unique_ptr<Solver> another() const override { return std::make_unique<Auto>(); }

  private:
    // Returns whether a factorisation may take no more than `most` multiply-adds.
    bool plans(const Island& island, double most) {
        if (UnitProblem::assembly_work(island.rows, false) > most) return false;
        exact_.take(island);
        if (work_of_a_pair * exact_.pairs() > most) return false;
        exact_.plan(most);
        return true;
    }

    // Returns whether nothing is left to do in this column; otherwise the forces are the better ones of guess and
    // result.
    bool solve_exactly(const Termination& termination, double of_one, Effort& effort, SolveCount& count) {
        if (exact_.step_work(rows_) > of_one) return false;
        const double guessed = rows_.residual();
        guess_ = rows_.rows;
        effort.begin_column();
        count.exact = exact_.solve(rows_, termination.tolerance_low, termination.tolerance_high, effort, count);
        // Sweeps cannot lower the residual of contradicting rows either.
        if (count.exact || count.contradicts) return true;
        count.multiply_adds += rows_.look_work();
        const double reached = rows_.residual();
        count.exact = reached <= std::max(termination.tolerance_high, termination.will_do);
        if (!count.exact && (termination.iterations == 0 || reached > guessed)) {
            rows_.rows = guess_;
            rows_.follow();
        }
        return count.exact;
    }

    UnitRows rows_;
    std::vector<UnitRow> guess_;
    ExactAnswer exact_;
};

}  // namespace

std::unique_ptr<Solver> make_auto() {
    return std::make_unique<Auto>();
}

}  // namespace pushfactor::engine::solvers
