// Distribution of the islands of a step: one thread solves all of them, or several threads solve small ones
// concurrently and large ones together.
#pragma once

#include "engine/base/threads.h"
#include "engine/solvers/solver.h"
#include "engine/step/island_solver.h"
#include "engine/step/small_steps.h"
#include "engine/system/dissection.h"
#include "engine/system/islands.h"

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

namespace pushfactor::engine {

// Work of solves: the sweeps of the island with the most of them, and sums over islands.
struct SolveWork {
    int sweeps = 0;
    double row_updates = 0.0, multiply_adds = 0.0;
    double alone = 0.0;  // multiply-adds of the most expensive island that is solved by one thread

    SolveWork() = default;
    SolveWork(const Island& island, const solvers::SolveCount& count)
        : sweeps(count.iterations),
          row_updates(count.row_updates > 0.0 ? count.row_updates
                                              : 1.0 * island.rows * island.columns * count.iterations),
          multiply_adds(count.multiply_adds),
          alone(is_large(island) ? 0.0 : count.multiply_adds) {}

    // Whether all threads solve it together.
    static bool is_large(const Island& island) { return island.rows >= Dissection::least_rows; }

    // Adds other islands of the same round.
    void add(const SolveWork& other);
    // Adds another round.
    void operator+=(const SolveWork& other);
};

class Benches {
  public:
    // Sets the tools of the first thread; the others get copies. Without `threads` there is one thread.
    void set_up(solvers::Solver* solver, SmallSteps* small_steps, Threads* threads);

    // Calls `solve(island, bench)`, which returns a SolveWork, for the islands of these numbers, in any order.
    template <typename Solve>
    SolveWork solve(std::span<const Island> islands, std::span<const int> numbers, const Solve& solve);

  private:
    template <typename Solve>
    void solve_side_by_side(std::span<const Island> islands, const Solve& solve);

    Threads* threads_ = nullptr;
    std::vector<IslandSolver::Bench> benches_;  // one per thread
    std::vector<std::unique_ptr<solvers::Solver>> other_solvers_;
    std::vector<std::unique_ptr<SmallSteps>> other_small_steps_;
    std::vector<int> numbers_;      // of the current islands, small ones first
    std::vector<SolveWork> works_;  // in the order of numbers_
};

template <typename Solve>
SolveWork Benches::solve(std::span<const Island> islands, std::span<const int> numbers, const Solve& solve) {
    SolveWork work;
    if (benches_.size() == 1) {
        for (const int number : numbers)
            work.add(solve(islands[static_cast<std::size_t>(number)], benches_.front()));
        return work;
    }
    numbers_.assign(numbers.begin(), numbers.end());
    solve_side_by_side(islands, solve);
    for (const SolveWork& of_island : works_) work.add(of_island);
    return work;
}

// Large islands one after the other, so that all threads work on each.
template <typename Solve>
void Benches::solve_side_by_side(std::span<const Island> islands, const Solve& solve) {
    const auto island_of = [&](int number) -> const Island& { return islands[static_cast<std::size_t>(number)]; };
    works_.assign(numbers_.size(), {});
    const auto first_large = std::stable_partition(
        numbers_.begin(), numbers_.end(), [&](int number) { return !SolveWork::is_large(island_of(number)); });
    const auto small = static_cast<std::size_t>(first_large - numbers_.begin());
    threads_->share(small, 1, [&](std::size_t begin, std::size_t end, int slot) {
        IslandSolver::Bench& bench = benches_[static_cast<std::size_t>(slot)];
        for (std::size_t k = begin; k < end; ++k) works_[k] = solve(island_of(numbers_[k]), bench);
    });
    IslandSolver::Bench& first = benches_.front();
    first.threads = threads_;
    for (std::size_t k = small; k < numbers_.size(); ++k) works_[k] = solve(island_of(numbers_[k]), first);
    first.threads = nullptr;
}

}  // namespace pushfactor::engine
