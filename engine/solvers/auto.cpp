// Sweeps contract slowly where a force has a long way to go (stacks, chains, great mass ratios), and exactly there
// the bodies are connected like a thread: the matrix of the exact answer has little fill, and a factorisation costs
// about as much as a few sweeps. Where the bodies are connected like a heap it is the other way round: a
// factorisation costs as much as many sweeps, and while the heap moves its clamped rows change all the time.
//
// So, of each island: keep the guess when it is good; take the answer of a single row at once; solve a thread
// exactly, and a tree if that costs no more than its sweeps; sweep a heap. A heap whose sweeps end far from the
// answer gets a bounded number of exact steps on top. The rules look at the structure and the residual, never at
// the clock.
#include "engine/solvers/auto.h"

#include "engine/solvers/by_columns.h"
#include "engine/solvers/exact_answer.h"
#include "engine/solvers/single_row.h"
#include "engine/solvers/sweep.h"

namespace pushfactor::engine::solvers {

namespace {

// From here on not even the order of elimination is worth finding out.
constexpr double pairs_of_a_heap = 2.2;
// Factorisations of an exact answer, at least: cut short it is worth little, and the iterations of a scene are
// meant for sweeps.
constexpr int factorisations_of_a_thread = 100;
// What is left after the sweeps of a heap that calls for exact steps [m/s].
constexpr double far = 3e-2;
// How many, and what one may cost in sweeps, so that a step never costs more than a few times its sweeps.
constexpr int exact_steps = 4;
constexpr double sweeps_an_exact_step = 25.0;

// What roundings leave of the largest speed that a row is asked for, where no tolerance is given.
constexpr double rounding = 1e-12;

template <int columns>
class Auto {
  public:
    SolveCount solve(const SystemEquation& system, const Island& island, const Termination& termination,
                     Columns& lambda) {
        if (island.rows == 1) return solve_single_row(system, island, termination, lambda);
        SolveCount count;
        rows_.load(system, island, lambda);
        if (keeps_guess(rows_, termination, count)) return count;
        exact_.take(island);
        if (exact_.pairs() <= pairs_of_a_thread * island.movable()) {
            solve_thread(termination, count);
        } else if (exact_.is_tree() && !rows_.bounds_follow()) {
            solve_tree(termination, count);
        } else {
            solve_heap(island, termination, count);
        }
        rows_.store(system, island, lambda);
        return count;
    }

  private:
    void solve_thread(const Termination& termination, SolveCount& count) {
        exact_.plan();
        exact_.solve(rows_, termination.tolerance_low, std::max(termination.iterations, factorisations_of_a_thread),
                     count);
        count.exact = true;
    }

    // Movable bodies connected without a cycle: the factor has no fill-in, and at rest one or two factorisations
    // are enough. The budget is the cost of the sweeps, which follow when it is used up.
    void solve_tree(const Termination& termination, SolveCount& count) {
        exact_.plan();
        const double sweeps = termination.iterations * rows_.pass_work();
        const int factorisations = static_cast<int>(sweeps / (exact_.factor_work() + rows_.factor_rows_work()));
        if (factorisations > 0) exact_.solve(rows_, termination.tolerance_low, factorisations, count);
        const double enough = std::max(termination.tolerance_low, rounding * rows_.fastest());
        count.exact = factorisations > 0 && count.residual <= enough;
        if (!count.exact) work_down(rows_, termination, count, sweep<columns>);
    }

    void solve_heap(const Island& island, const Termination& termination, SolveCount& count) {
        if (work_down(rows_, termination, count, sweep<columns>)) return;
        if (exact_.pairs() > pairs_of_a_heap * island.movable()) return;
        count.multiply_adds += rows_.look_work();
        if (rows_.residual() <= far) return;
        exact_.plan();
        if (exact_.factor_work() > sweeps_an_exact_step * rows_.pass_work()) return;
        exact_.solve(rows_, termination.tolerance_low, exact_steps, count);
    }

    UnitRows<columns> rows_;
    ExactAnswer exact_;
};

}  // namespace

std::unique_ptr<Solver> make_auto() {
    return std::make_unique<ByColumns<Auto>>();
}

}  // namespace pushfactor::engine::solvers
