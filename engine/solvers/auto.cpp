// Sweeps contract slowly where a force has a long way to go (stacks, chains, great mass ratios), and exactly there
// the bodies are connected like a thread: the matrix of the exact answer has little fill, and a factorisation costs
// about as much as a few sweeps. Where the bodies are connected like a heap it is the other way round: a
// factorisation costs as much as many sweeps, and while the heap moves its clamped rows change all the time.
//
// So: keep the guess when it is good; sweep once where no two rows share a body, which is the answer; solve a
// thread exactly; sweep a heap. A heap whose sweeps end far from the answer gets a bounded number of exact steps on
// top. The rules look at the structure and the residual, never at the clock.
#include "engine/solvers/auto.h"

#include "engine/solvers/by_columns.h"
#include "engine/solvers/exact_answer.h"
#include "engine/solvers/sweep.h"

namespace pushfactor::engine::solvers {

namespace {

// Pairs a movable body, static partners included: 1 for a thread that hangs or stands, 1.5 for the pendulum grid,
// for which the exact answer costs no more than 25 sweeps, and about 3 for a heap.
constexpr double pairs_of_a_thread = 1.5;
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

template <int columns>
class Auto {
  public:
    SolveCount solve(const SystemEquation& system, const Termination& termination, Columns& lambda) {
        SolveCount count;
        rows_.load(system, lambda);
        if (keeps_guess(rows_, termination, count)) return count;
        exact_.find_pairs(rows_);
        if (!exact_.rows_couple()) {
            work_down(rows_, {1, termination.tolerance_high, termination.tolerance_low}, count, sweep<columns>);
        } else if (exact_.pairs() <= pairs_of_a_thread * exact_.movable_bodies()) {
            exact_.plan();
            exact_.solve(rows_, termination.tolerance_low,
                         std::max(termination.iterations, factorisations_of_a_thread), count);
            count.exact = true;
        } else {
            solve_heap(termination, count);
        }
        rows_.store(system, lambda);
        return count;
    }

  private:
    void solve_heap(const Termination& termination, SolveCount& count) {
        if (work_down(rows_, termination, count, sweep<columns>)) return;
        if (exact_.pairs() > pairs_of_a_heap * exact_.movable_bodies()) return;
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
