// Sweeps converge slowly where a force has to travel far (stacks, chains, large mass ratios). Exactly there the
// bodies are connected like a chain: the matrix of the exact method has little fill-in, and a factorisation costs
// about as much as a few sweeps. In heaps it is the other way round: a factorisation costs as much as many sweeps,
// and while the heap moves its clamped rows change all the time.
//
// So, per island: a single row is solved directly; a chain is solved exactly, and so are a tree if that costs no
// more than its sweeps, and anything at rest that may keep its solution; a heap is swept. A heap whose sweeps end
// far from the solution gets a bounded number of exact steps on top. A pile that is about to touch looks like a
// chain but is none: exact solves have to pay off, which the account of the island tracks (budget.h); one that is
// cut short restores the warm start, and sweeps follow. The rules depend on structure, residual and account, never
// on the clock.
//
// A mechanism (bodies on joints) gets exact steps in every step, whatever it touches and however the last one
// ended: forces that are far from the solution pull its joints apart and give it energy.
#include "engine/solvers/auto.h"

#include "engine/solvers/by_columns.h"
#include "engine/solvers/exact/exact_answer.h"
#include "engine/solvers/single_row.h"
#include "engine/solvers/sweep.h"

#include <algorithm>

namespace pushfactor::engine::solvers {

namespace {

// Pairs per movable body from which on not even the elimination order is computed.
constexpr double pairs_of_a_heap = 2.2;
// Least factorisations per exact solve after a change; the second value if the residual of the warm start exceeds
// `near_guess` of fastest().
constexpr double least_factorisations = 2.0, least_from_afar = 16.0;
constexpr double near_guess = 1e-2;
// Largest cost of one factorisation, in sweeps: those of towers and walls cost 17 to 82 and reach the solution,
// those of settling heaps cost 100 and more and do not.
constexpr double most_sweeps_a_factorisation = 90.0;
// Iteration limit below which the sweeps of a heap may have achieved nothing (the re-solves of a step have used up
// the others). An island of at most `small_island` bodies then gets its exact steps for any connectivity.
constexpr int enough_sweeps = 7;
constexpr int small_island = 32;
// Residual after the sweeps of a heap that calls for exact steps, as a share of fastest(): 3 cm/s for something
// that lands at 3 m/s.
constexpr double far = 1e-2;
// Number of exact steps, and the largest cost of one in sweeps, so that a step never costs more than a few times
// its sweeps.
constexpr int exact_steps = 4;
constexpr double sweeps_an_exact_step = 25.0;
// Residual up to which a truncated exact solve is kept when the bodies are at rest, as shares of the warm start's
// residual and of fastest(): the next step continues from it.
constexpr double much_better = 0.1, near = 0.02;
// Residual up to which an exact solve counts as successful although it missed the tolerance, as a share of
// fastest().
constexpr double good_share = 1e-6;
// Multiply-adds per body that exact steps of a mechanism may take.
constexpr double work_of_a_mechanism = 1.5e5;

template <int columns>
class Auto {
  public:
    SolveCount solve(const SystemEquation& system, const Island& island, const Termination& termination,
                     Columns& lambda) {
        if (island.rows == 1) return solve_single_row(system, island, lambda);
        SolveCount count;
        exact_.take(island);
        const bool is_thread = exact_.pairs() <= pairs_of_a_thread * island.movable();
        is_mechanism_ = island.has(RowDigest::joins);
        const bool is_heap = !termination.lasts && !is_thread && !exact_.is_tree() && !is_mechanism_;
        if (is_heap && termination.iterations == 0) return count;
        rows_.load(system, island, lambda);
        if (is_mechanism_) {
            Termination own = termination;
            own.credit = std::max(own.credit, work_of_a_mechanism * island.movable());
            solve_thread(own, count);
        } else if (termination.lasts || is_thread || (exact_.is_tree() && !rows_.bounds_follow())) {
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
        if (pays_off(termination, guessed) && solve_exactly(termination, guessed, count)) return;
        if (!is_mechanism_) {
            work_down(rows_, termination, count, sweep<columns>);
            return;
        }
        // The exact steps have reached something that sweeps may spoil.
        const double reached = rows_.residual();
        const std::vector<typename UnitRows<columns>::Row> before = rows_.rows;
        work_down(rows_, termination, count, sweep<columns>);
        count.multiply_adds += 2.0 * rows_.look_work();
        if (rows_.residual() < reached) return;
        rows_.rows = before;
        rows_.follow();
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

    // Returns whether that succeeded; otherwise restores the forces.
    bool solve_exactly(const Termination& termination, double guessed, SolveCount& count) {
        guess_ = rows_.rows;
        Effort effort(termination.credit);
        count.exact = exact_.solve(rows_, termination.tolerance_low, termination.tolerance_high, effort, count);
        // Sweeps cannot lower the residual of contradicting rows either.
        count.exhausted = count.contradicts;
        if (count.exact || count.contradicts) return true;
        count.multiply_adds += rows_.look_work();
        if (rows_.residual() <= good_share * rows_.fastest()) return true;
        // In a moving heap a truncated exact solve is a worse start than the warm start.
        const double reached = rows_.residual();
        if (is_mechanism_ && reached < guessed) return false;
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

    bool is_mechanism_ = false;  // the current island has joints
    UnitRows<columns> rows_;
    std::vector<typename UnitRows<columns>::Row> guess_;
    ExactAnswer exact_;
};

}  // namespace

std::unique_ptr<Solver> make_auto() {
    return std::make_unique<ByColumns<Auto>>();
}

}  // namespace pushfactor::engine::solvers
