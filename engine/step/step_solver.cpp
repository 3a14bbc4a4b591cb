#include "engine/step/step_solver.h"

#include <algorithm>

namespace pushfactor::engine {

namespace {

bool has_row_from(const Island& island, std::size_t first_row) {
    return static_cast<std::size_t>(island.runs.back().end) > first_row;
}

}  // namespace

void StepSolver::begin(const StepProblem& problem) {
    const SystemEquation& system = problem.system;
    island_solver_.begin(problem.bodies.size(), system.awake);
    islands_.find(system, problem.threads);
    lambda_.resize(system.row_count(), system.column_count());
    guess(problem, 0, lambda_);
    forces_.moving.resize(problem.bodies.size());
    forces_.lasting.resize(problem.bodies.size());
    for (const int body : system.awake) forces_.moving[static_cast<std::size_t>(body)].setZero();
}

SolveWork StepSolver::solve(const StepProblem& problem) {
    begin(problem);
    choose([](const Island&) { return true; }, problem.bodies.size());
    return solve_chosen(problem,
                        [&](const Island& island, auto& bench) { return solve(problem, island, nullptr, bench); });
}

SolveWork StepSolver::solve_again(const StepProblem& problem, std::size_t first_new) {
    const SystemEquation& system = problem.system;
    islands_.find(system);
    const bool second_column = system.column_count() > lambda_.cols();
    lambda_.conservativeResize(system.row_count(), system.column_count());
    if (second_column) lambda_.col(1) = lambda_.col(0);
    guess(problem, first_new, lambda_);
    first_guess_.resize(lambda_.rows(), lambda_.cols());
    guess(problem, 0, first_guess_);
    choose([&](const Island& island) { return has_row_from(island, first_new); }, problem.bodies.size());
    return solve_chosen(
        problem, [&](const Island& island, auto& bench) { return solve(problem, island, &first_guess_, bench); });
}

SolveWork StepSolver::solve_separately(const StepProblem& problem, std::span<const int> numbers, Columns& lambda) {
    benches_.set_up(problem.solver, problem.small_steps, problem.threads);
    return benches_.solve(islands_.all(), numbers, [&](const Island& island, auto& bench) {
        return SolveWork(island, island_solver_.solve(bench, problem.termination, problem.system, problem.bodies,
                                                      island, nullptr, lambda, forces_));
    });
}

template <typename Predicate>
void StepSolver::choose(const Predicate& predicate, std::size_t bodies) {
    changed_.assign(bodies, 0);
    chosen_.clear();
    for (std::size_t k = 0; k < islands_.all().size(); ++k) {
        if (predicate(islands_.all()[k])) chosen_.push_back(static_cast<int>(k));
    }
}

template <typename Solve>
SolveWork StepSolver::solve_chosen(const StepProblem& problem, const Solve& solve) {
    if (chosen_.empty()) return {};
    if (problem.small_steps) endings_.resize(problem.system.rows.size());
    benches_.set_up(problem.solver, problem.small_steps, problem.threads);
    const SolveWork work = benches_.solve(islands_.all(), chosen_, solve);
    for (const int number : chosen_) note_changed(islands_.all()[static_cast<std::size_t>(number)]);
    return work;
}

void StepSolver::note_changed(const Island& island) {
    for (const int body : island.bodies) changed_[static_cast<std::size_t>(body)] = 1;
}

SolveWork StepSolver::solve(const StepProblem& problem, const Island& island, Columns* first_guess,
                            IslandSolver::Bench& bench) {
    SolveWork work(island, island_solver_.solve(bench, problem.termination, problem.system, problem.bodies, island,
                                                first_guess, lambda_, forces_));
    if (!outcome_of(island).unfinished) return work;
    work.add(SolveWork(island, island_solver_.take_small_steps(bench, problem.system, problem.bodies, island,
                                                               problem.sources, lambda_, forces_, endings_)));
    return work;
}

void StepSolver::guess(const StepProblem& problem, std::size_t first_row, Columns& lambda) const {
    const SystemEquation& system = problem.system;
    const std::span<const ConstraintRow> rows = system.rows;
    const Eigen::Index last = lambda.cols() - 1;
    share(problem.threads, rows.size() - first_row, rows_of_a_part, [&](std::size_t begin, std::size_t end) {
        for (std::size_t j = first_row + begin; j < first_row + end; ++j) {
            const auto row = static_cast<Eigen::Index>(j);
            lambda(row, 0) = rows[j].guess.first;
            lambda(row, last) = rows[j].guess.last;  // with one column these forces set the momenta
        }
    });
    for (const Island& island : islands_.all()) {
        if (island.columns > last || !has_row_from(island, first_row)) continue;
        for (const RowRun& run : island.runs) {
            for (int j = std::max(run.begin, static_cast<int>(first_row)); j < run.end; ++j) {
                lambda(j, 0) = lambda(j, last);
            }
        }
    }
    // Rows without movable bodies belong to no island.
    for (std::size_t j = first_row; j < rows.size() && !islands_.hold_all_rows(); ++j) {
        const auto row = static_cast<Eigen::Index>(j);
        if (!(system.diagonal[row] > 0.0)) lambda.row(row).setZero();
    }
}

std::span<const Lambda> StepSolver::end(const StepProblem& problem) {
    const SystemEquation& system = problem.system;
    answers_.assign(system.rows.size(), {});
    for (const Island& island : islands_.all()) {
        share_each(problem.threads, island.runs, rows_of_a_part,
                   [&](const RowRun& run) { find_next_guesses(island, run); });
    }
    return answers_;
}

// Forces of contradicting rows are as large as the method allows, and no start for the next step.
void StepSolver::find_next_guesses(const Island& island, const RowRun& run) {
    const IslandSolver::Outcome& outcome = outcome_of(island);
    if (outcome.contradicts) return;
    if (outcome.method == IslandSolver::Method::in_small_steps) {
        std::copy(endings_.begin() + run.begin, endings_.begin() + run.end, answers_.begin() + run.begin);
        return;
    }
    const Eigen::Index last = lambda_.cols() - 1;
    for (int j = run.begin; j < run.end; ++j) {
        answers_[static_cast<std::size_t>(j)] = {lambda_(j, 0), lambda_(j, last)};
    }
}

void StepSolver::leave_out_others(std::span<const Body> bodies, const Awake& awake, std::span<const int> changed) {
    forces_.moving.resize(bodies.size());
    for (const int body : changed) {
        const Body& own = bodies[static_cast<std::size_t>(body)];
        if (!awake.has(body)) forces_.moving[static_cast<std::size_t>(body)] = -stacked(own.force, own.torque);
    }
}

double StepSolver::residual(const SystemEquation& system, const solvers::Termination& termination) const {
    const bool all_measured = termination.tolerance_high > 0.0;
    // With a fixed number of iterations the solve has not computed the residual.
    if (!all_measured) {
        const auto took_small_steps = [this](const Island& island) {
            return outcome_of(island).method == IslandSolver::Method::in_small_steps;
        };
        const std::span<const Island> islands = islands_.all();
        if (std::none_of(islands.begin(), islands.end(), took_small_steps)) {
            return natural_residual(system, lambda_);
        }
    }
    double largest = 0.0;
    for (const Island& island : islands_.all()) {
        const IslandSolver::Outcome& outcome = outcome_of(island);
        const bool measured = all_measured || outcome.method == IslandSolver::Method::in_small_steps;
        const double own = measured ? std::max(outcome.residuals[0], outcome.residuals[1])
                                    : island_residual(system, island, lambda_);
        if (!(own <= largest)) largest = own;
    }
    return largest;
}

StepCount StepSolver::count(const SystemEquation& system, const SolveWork& work) const {
    StepCount count;
    if (!system.rows.empty()) {
        for (const RowDigest& row : system.digests) ++count.rows_of_kind[static_cast<std::size_t>(row.kind)];
    }
    count.columns = system.rows.empty() ? 0 : static_cast<int>(system.column_count());
    count.islands = static_cast<int>(islands_.all().size());
    for (const Island& island : islands_.all()) {
        const IslandSolver::Outcome& outcome = outcome_of(island);
        if (!outcome.solved) {
            ++count.islands_unsolved;
            count.unsolved_residual =
                std::max({count.unsolved_residual, outcome.residuals[0], outcome.residuals[1]});
        }
        count.islands_contradicting += outcome.contradicts;
        switch (outcome.method) {
            case IslandSolver::Method::kept:
                ++count.islands_kept;
                break;
            case IslandSolver::Method::swept:
                ++count.islands_swept;
                break;
            case IslandSolver::Method::exact:
                ++count.islands_exact;
                break;
            case IslandSolver::Method::in_small_steps:
                ++count.islands_in_small_steps;
        }
    }
    count.sweeps = work.sweeps;
    count.row_updates = work.row_updates;
    count.multiply_adds = work.multiply_adds;
    return count;
}

}  // namespace pushfactor::engine
