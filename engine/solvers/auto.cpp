// Sweeps contract slowly where a force has a long way to go (stacks, chains, great mass ratios), and exactly there
// the bodies are connected like a thread: the matrix of the exact answer has little fill, and a factorisation costs
// about as much as a few sweeps. Where the bodies are connected like a heap it is the other way round: a
// factorisation costs as much as many sweeps, and while the heap moves its clamped rows change all the time.
//
// So, of each island: take the answer of a single row at once; solve a thread exactly, a tree if that costs no more
// than its sweeps, and whatever stands and may keep its answer; sweep a heap. A heap whose sweeps end far from the
// answer gets a bounded number of exact steps on top. A pile that begins to touch looks like a thread and is none:
// exact answers have to pay off, which the account of the island knows (budget.h); one that is cut short gives back
// the guess that it came with, and sweeps follow. The rules look at the structure, the residual and the account,
// never at the clock.
#include "engine/solvers/auto.h"

#include "engine/solvers/by_columns.h"
#include "engine/solvers/exact/exact_answer.h"
#include "engine/solvers/single_row.h"
#include "engine/solvers/sweep.h"

#include <algorithm>

namespace pushfactor::engine::solvers {

namespace {

// From here on not even the order of elimination is worth finding out.
constexpr double pairs_of_a_heap = 2.2;
// Factorisations that an exact answer takes at least where something has changed, and from a guess with more than
// this share of the largest speed that a row is asked for.
constexpr double least_factorisations = 2.0, least_from_afar = 16.0;
constexpr double near_guess = 1e-2;
// What one may cost at most, in sweeps: those of towers and walls cost 17 to 82 and lead to the end, those of heaps
// that settle 100 and more and do not.
constexpr double most_sweeps_a_factorisation = 90.0;
// Sweeps below which those of a heap may not have got anywhere: what looks have left of them. An island of so many
// bodies gets its exact steps then, however they are connected.
constexpr int enough_sweeps = 7;
constexpr int small_island = 32;
// What is left after the sweeps of a heap that calls for exact steps, as a share of the largest speed that a row is
// asked for: 3 cm/s where something lands with 3 m/s.
constexpr double far = 1e-2;
// How many, and what one may cost in sweeps, so that a step never costs more than a few times its sweeps.
constexpr int exact_steps = 4;
constexpr double sweeps_an_exact_step = 25.0;
// Shares, of its guess's residual and of the largest speed that a row is asked for, with which an answer that was
// cut short is worth having where all stand: the next step goes on from it.
constexpr double much_better = 0.1, near = 0.02;
// Share of the largest speed that a row is asked for below which an exact answer is one, though it may have
// stopped short of the tolerance.
constexpr double good_share = 1e-6;

template <int columns>
class Auto {
  public:
    SolveCount solve(const SystemEquation& system, const Island& island, const Termination& termination,
                     Columns& lambda) {
        if (island.rows == 1) return solve_single_row(system, island, lambda);
        SolveCount count;
        exact_.take(island);
        const bool is_thread = exact_.pairs() <= pairs_of_a_thread * island.movable();
        const bool is_heap = !termination.lasts && !is_thread && !exact_.is_tree();
        if (is_heap && termination.iterations == 0) return count;
        rows_.load(system, island, lambda);
        if (termination.lasts || is_thread || (exact_.is_tree() && !rows_.bounds_follow())) {
            solve_thread(termination, count);
        } else {
            solve_heap(island, termination, count);
        }
        rows_.store(system, island, lambda);
        return count;
    }

  private:
    void solve_thread(const Termination& termination, SolveCount& count) {
        const double guessed = termination.credit > 0.0 ? rows_.residual() : 0.0;
        if (!pays_off(termination, guessed) || !solve_exactly(termination, guessed, count)) {
            work_down(rows_, termination, count, sweep<columns>);
        }
    }

    bool pays_off(const Termination& termination, double guessed) {
        if (!(termination.credit > 0.0)) return false;
        const bool is_near = guessed <= near_guess * rows_.fastest();
        const double least = is_near ? least_factorisations : least_from_afar;
        const double most =
            std::min(termination.credit / least, most_sweeps_a_factorisation * rows_.pass_work()) / columns;
        exact_.plan(most);
        return exact_.factorisation(rows_) <= most;
    }

    // Returns whether that led anywhere; else the forces are those from before.
    bool solve_exactly(const Termination& termination, double guessed, SolveCount& count) {
        guess_ = rows_.rows;
        Effort effort(termination.credit);
        count.exact = exact_.solve(rows_, termination.tolerance_low, termination.tolerance_high, effort, count);
        // What rows that contradict each other leave, sweeps cannot lower either.
        count.exhausted = count.contradicts;
        if (count.exact || count.contradicts) return true;
        count.multiply_adds += rows_.look_work();
        if (rows_.residual() <= good_share * rows_.fastest()) return true;
        // In a heap that moves an answer that was cut short is worse to go on from than the guess.
        const double reached = rows_.residual();
        if (termination.lasts && reached <= much_better * guessed && reached <= near * rows_.fastest()) return true;
        count.gave_up = true;
        rows_.rows = guess_;
        rows_.follow();
        return false;
    }

    void solve_heap(const Island& island, const Termination& termination, SolveCount& count) {
        if (termination.iterations == 0) return;
        if (work_down(rows_, termination, count, sweep<columns>)) return;
        const bool few_sweeps = termination.iterations < enough_sweeps && island.movable() <= small_island;
        if (!few_sweeps && exact_.pairs() > pairs_of_a_heap * island.movable()) return;
        count.multiply_adds += rows_.look_work();
        const double swept = rows_.residual();
        if (swept <= far * rows_.fastest()) return;
        const double most =
            std::min(sweeps_an_exact_step * rows_.pass_work(), termination.credit / (exact_steps * columns));
        exact_.plan(most);
        if (exact_.factorisation(rows_) > most) return;
        Effort effort(termination.credit, exact_steps);
        exact_.solve(rows_, termination.tolerance_low, termination.tolerance_high, effort, count);
        count.gave_up = rows_.residual() > 0.5 * swept;
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
