// The exact solution where it is worth its cost, else sweeps from the guess.
//
// Sweeps converge slowly where a force has to travel far (stacks, chains, large mass ratios). Exactly there the
// bodies are connected like a chain: the matrix of the exact method has little fill-in, and a factorisation costs
// about as much as a few sweeps. In heaps it is the other way round. What an exact solution is worth is known to
// the caller (Termination::worth), and what a factorisation costs is known before it is made, from its plan; so the
// rule depends on structure and guess, never on earlier steps or the clock.
#include "engine/solvers/auto.h"

#include "engine/solvers/by_columns.h"
#include "engine/solvers/direct.h"
#include "engine/solvers/exact/exact_answer.h"
#include "engine/solvers/single_row.h"
#include "engine/solvers/sweep.h"

#include <algorithm>

namespace pushfactor::engine::solvers {

namespace {

// Least multiply-adds of a factorisation per pair of bodies: one block.
constexpr double work_of_a_pair = 216.0;

template <int columns>
class Auto {
  public:
    SolveCount solve(const SystemEquation& system, const Island& island, const Termination& termination,
                     Columns& lambda) {
        if (island.rows == 1) return solve_single_row(system, island, lambda);
        SolveCount count;
        const double worth = std::min(termination.worth, most_work_of_a_column * columns);
        const double of_one = worth / (termination.factorisations * columns);
        const bool may_be_worth = plans(island, of_one);
        if (!may_be_worth && termination.iterations == 0) return count;
        rows_.load(system, island, lambda);
        const bool done = may_be_worth && solve_exactly(termination, of_one, worth, count);
        if (!done) work_down(rows_, termination, count, sweep<columns>);
        rows_.store(system, island, lambda);
        return count;
    }

  private:
    // Returns whether a factorisation may take no more than `most` multiply-adds.
    bool plans(const Island& island, double most) {
        if (UnitProblem::assembly_work(island.rows, false) > most) return false;
        exact_.take(island);
        if (work_of_a_pair * exact_.pairs() > most) return false;
        exact_.plan(most);
        return true;
    }

    // Returns whether nothing is left to do; otherwise the forces are the better ones of guess and result.
    bool solve_exactly(const Termination& termination, double of_one, double worth, SolveCount& count) {
        if (exact_.step_work(rows_) > of_one) return false;
        const double guessed = rows_.residual();
        guess_ = rows_.rows;
        Effort effort(worth);
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

    UnitRows<columns> rows_;
    std::vector<typename UnitRows<columns>::Row> guess_;
    ExactAnswer exact_;
};

}  // namespace

std::unique_ptr<Solver> make_auto() {
    return std::make_unique<ByColumns<Auto>>();
}

}  // namespace pushfactor::engine::solvers
