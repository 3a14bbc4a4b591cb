// The exact solution where it is worth its cost, else sweeps.
//
// Sweeps converge slowly where a force has to travel far (stacks, chains, large mass ratios). Exactly there the
// bodies are connected like a chain: the matrix of the exact method has little fill-in, and a factorisation costs
// about as much as a few sweeps. In heaps it is the other way round. What an exact solution is worth is known to
// the caller (Termination::worth), and what a factorisation costs is known before it is made, from its plan; so the
// rule depends on structure and guess, never on earlier steps or the clock.
#include "engine/solvers/direct.h"

#include "engine/solvers/exact/exact_answer.h"
#include "engine/solvers/single_row.h"
#include "engine/solvers/sweep.h"

#include <algorithm>

namespace pushfactor::engine::solvers {

namespace {

// Least multiply-adds of a factorisation per pair of bodies: one block.
constexpr double work_of_a_pair = 216.0;
// Expected factorisations of an exact solution that is wanted at any cost.
constexpr double usual_factorisations = 25.0;
// Sweeps at most after one that has failed.
constexpr int most_sweeps = 200;

class Direct : public Solver {
  public:
    explicit Direct(bool at_any_cost) : at_any_cost_(at_any_cost) {}

    SolveCount solve(const SystemEquation& system, const Island& island, const Termination& termination,
                     Columns& lambda) override {
        if (island.rows == 1) {
            SolveCount single = solve_single_row(system, island, lambda);
            single.exact = at_any_cost_;
            return single;
        }
        Termination own = termination;
        if (at_any_cost_) {
            own.worth = most_exact_work * island.columns;
            own.factorisations = usual_factorisations;
            own.iterations = std::min(termination.iterations, most_sweeps);
        }
        const double of_one = own.worth / (own.factorisations * island.columns);
        bool may_be_worth = plans(island, of_one);
        if (!may_be_worth && own.iterations == 0) return {};
        Effort effort(own.worth, island.columns, at_any_cost_ ? termination.iterations : infinity);
        return by_columns(rows_, system, island, lambda, [&](UnitRows&) {
            SolveCount count;
            guess_.clear();
            if (may_be_worth && solve_exactly(own, of_one, effort, count)) return count;
            if (own.iterations == 0) may_be_worth = false;  // no other column will do either
            sweep_down(own, count);
            if (at_any_cost_ && !guess_.empty() && rows_.residual() > own.tolerance_low)
                sweep_from_guess(own, count);
            return count;
        });
    }
    std::unique_ptr<Solver> another() const override { return std::make_unique<Direct>(at_any_cost_); }

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
        const double step_work = exact_.step_work(rows_);
        if (step_work > of_one) return false;
        const double guessed = rows_.residual();
        guess_ = rows_.rows;
        effort.begin_column(termination.at_least * step_work);
        const double will_do = at_any_cost_ ? termination.tolerance_low : termination.tolerance_high;
        count.exact = exact_.solve(rows_, termination.tolerance_low, will_do, effort, count);
        // Sweeps cannot lower the residual of contradicting rows either.
        if (count.exact || count.contradicts) return true;
        count.multiply_adds += rows_.look_work();
        const double reached = rows_.residual();
        // What is within the upper tolerance needs no more, although rounding or the effort has ended it early.
        count.exact = reached <= std::max(termination.tolerance_high, termination.will_do);
        if (!count.exact && (termination.iterations == 0 || reached > guessed)) {
            rows_.rows = guess_;
            rows_.follow();
        }
        return count.exact;
    }

    void sweep_down(const Termination& termination, SolveCount& count) {
        const SolveCount swept = work_down(rows_, termination, [](UnitRows& rows) { return sweep(rows); });
        count.iterations += swept.iterations;
        count.multiply_adds += swept.multiply_adds;
    }

    // Keeps the result if it is better than the current forces.
    void sweep_from_guess(const Termination& termination, SolveCount& count) {
        const double reached = rows_.residual();
        std::swap(rows_.rows, guess_);
        rows_.follow();
        sweep_down(termination, count);
        count.multiply_adds += 2.0 * rows_.look_work();
        if (rows_.residual() < reached) return;
        std::swap(rows_.rows, guess_);
        rows_.follow();
    }

    bool at_any_cost_;
    UnitRows rows_;
    std::vector<UnitRow> guess_;  // of an exact solution that was tried
    ExactAnswer exact_;
};

}  // namespace

std::unique_ptr<Solver> make_auto() {
    return std::make_unique<Direct>(false);
}

std::unique_ptr<Solver> make_direct() {
    return std::make_unique<Direct>(true);
}

}  // namespace pushfactor::engine::solvers
