#include "engine/step/benches.h"

namespace pushfactor::engine {

void SolveWork::add(const SolveWork& other) {
    sweeps = std::max(sweeps, other.sweeps);
    row_updates += other.row_updates;
    multiply_adds += other.multiply_adds;
    alone = std::max(alone, other.alone);
}

void SolveWork::operator+=(const SolveWork& other) {
    sweeps += other.sweeps;
    row_updates += other.row_updates;
    multiply_adds += other.multiply_adds;
    alone += other.alone;
}

void Benches::set_up(solvers::Solver* solver, SmallSteps* small_steps, Threads* threads) {
    threads_ = threads;
    const std::size_t count = threads ? static_cast<std::size_t>(threads->count()) : 1;
    const bool as_before = !benches_.empty() && benches_.front().solver == solver;
    if (!as_before) other_solvers_.clear();
    other_solvers_.resize(std::max(count - 1, other_solvers_.size()));
    other_small_steps_.resize(other_solvers_.size());
    benches_.resize(count);
    benches_.front().solver = solver;
    benches_.front().small_steps = small_steps;
    for (std::size_t k = 1; k < count; ++k) {
        if (!other_solvers_[k - 1] && solver) other_solvers_[k - 1] = solver->another();
        if (!other_small_steps_[k - 1] && small_steps) other_small_steps_[k - 1] = small_steps->another();
        benches_[k].solver = other_solvers_[k - 1].get();
        benches_[k].small_steps = other_small_steps_[k - 1].get();
    }
    if (count > 1 && !benches_.back().solver) benches_.resize(1);
}

}  // namespace pushfactor::engine
