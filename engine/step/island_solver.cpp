#include "engine/step/island_solver.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace pushfactor::engine {

namespace {

// Calls `visit` for each row of the runs and each of their columns.
template <typename Visit>
void each_force(std::span<const RowRun> runs, int columns, const Visit& visit) {
    for (const RowRun& run : runs) {
        for (Eigen::Index j = run.begin; j < run.end; ++j) {
            for (Eigen::Index column = 0; column < columns; ++column) visit(j, column);
        }
    }
}

template <typename Visit>
void each_force(const Island& island, const Visit& visit) {
    each_force(island.runs, island.columns, visit);
}

bool has_forces(const Island& island, const Columns& lambda) {
    bool any = false;
    each_force(island, [&](Eigen::Index j, Eigen::Index column) { any = any || lambda(j, column) != 0.0; });
    return any;
}

// An island of one column has the same forces in both.
void copy_to_last(const Island& island, Columns& lambda) {
    if (island.columns == lambda.cols()) return;
    each_force(island,
               [&](Eigen::Index j, Eigen::Index column) { lambda(j, lambda.cols() - 1) = lambda(j, column); });
}

// Clamps the forces to their bounds; leaders come before their followers. Returns whether any changed.
bool clamp(const SystemEquation& system, const Island& island, Columns& lambda, Threads* threads) {
    if (!island.has(RowDigest::limited)) return false;
    const auto clamp_some = [&](std::span<const RowRun> runs) {
        bool changed = false;
        each_force(runs, island.columns, [&](Eigen::Index j, Eigen::Index column) {
            changed = clamp_force(system.rows, j, column, lambda) || changed;
        });
        return changed;
    };
    bool any = false;
    if (!threads || island.follows_others) {
        any = clamp_some(island.runs);
    } else {
        std::atomic<bool> changed = false;
        threads->share(island.runs.size(), runs_of_a_part, [&](std::size_t begin, std::size_t end, int) {
            if (clamp_some(island.runs.subspan(begin, end - begin))) changed.store(true, std::memory_order_relaxed);
        });
        any = changed;
    }
    if (any) copy_to_last(island, lambda);
    return any;
}

// For a solver that was asked for an exact solution only; it has left lambda unchanged.
bool has_no_answer(const solvers::SolveCount& count) {
    return !count.exact && !count.contradicts && (count.gave_up || count.iterations == 0);
}

double larger(const std::array<double, 2>& residuals) {
    return std::max(residuals[0], residuals[1]);
}

}  // namespace

void IslandSolver::begin(std::size_t bodies, std::span<const int> awake) {
    warm_start_.begin(bodies, awake);
    budget_.begin(bodies, awake);
    outcomes_.resize(bodies);
    for (const int body : awake) outcomes_[static_cast<std::size_t>(body)] = {};
}

solvers::SolveCount IslandSolver::solve(Bench& bench, const solvers::Termination& usual,
                                        const SystemEquation& system, const Island& island, const Allowed& allowed,
                                        Columns* first_guess, Columns& lambda, ConstraintForces& forces) {
    const bool fixed_number = usual.tolerance_high <= 0.0;
    if (bench.threads) bench.runs_of.find(island);
    Outcome outcome;
    solvers::SolveCount count;
    if (fixed_number && allowed.iterates_up_to < infinity) {
        outcome.unfinished = true;
    } else if (fixed_number) {
        count = bench.solver->solve(system, island, budget_.limits(island, usual, Budget::Take::rest), lambda);
        find_forces(system, island, lambda, forces, bench);
    } else {
        outcome.residuals = measure(system, island, lambda, forces, bench);
        const double tolerance = warm_start_.tolerance_high(island, usual);
        if (larger(outcome.residuals) > tolerance) {
            const bool exact_only = larger(outcome.residuals) > allowed.iterates_up_to;
            outcome.outlook = outlook_of(island, larger(outcome.residuals), allowed, lambda);
            solvers::Termination termination = budget_.limits(
                island, usual, exact_only ? Budget::Take::exact_only : allowed.take, outcome.outlook);
            termination.tolerance_high = tolerance;
            outcome.outdated = is_outdated(system, island, lambda, usual, bench);
            count = find_better(bench, termination, system, island, first_guess, lambda, forces, outcome);
            outcome.solved = larger(outcome.residuals) <= usual.tolerance_high;
        }
    }
    note(island, outcome, count);
    if (!fixed_number) count.multiply_adds += 12.0 * island.rows * island.columns;
    return count;
}

// Bodies that were solved exactly so far may be hit harder than standing ones usually are, and are worth another
// exact solve.
Budget::Outlook IslandSolver::outlook_of(const Island& island, double residual, const Allowed& allowed,
                                         const Columns& lambda) const {
    const bool was_exact = allowed.stands_up_to > 0.0 && warm_start_.was_mostly_exact(island);
    const bool stands = residual <= allowed.stands_up_to;
    if (!stands && !was_exact) return Budget::Outlook::moving;
    const bool begins = stands && (was_exact || !has_forces(island, lambda));
    return begins ? Budget::Outlook::beginning : Budget::Outlook::standing;
}

// The residual left by small steps is not compared with a tolerance: the next small step reduces it.
solvers::SolveCount IslandSolver::take_small_steps(Bench& bench, const SystemEquation& system,
                                                   std::span<const Body> bodies, const Island& island,
                                                   Columns& lambda, ConstraintForces& forces,
                                                   std::span<Lambda> ending) {
    Outcome outcome = outcome_of(island);
    SmallSteps& small_steps = *bench.small_steps;
    const SmallSteps::Division division =
        small_steps.division_of(system.dt, bodies, island, larger(outcome.residuals));
    solvers::SolveCount count =
        small_steps.solve(system, bodies, island, division, bench.threads, lambda, forces, ending);
    outcome.solved = outcome.exhausted = outcome.in_small_steps = true;
    outcome.unfinished = false;
    outcome.residuals = {small_steps.residual(), small_steps.residual()};
    note(island, outcome, count);
    return count;
}

solvers::SolveCount IslandSolver::go_on(Bench& bench, const solvers::Termination& usual,
                                        const SystemEquation& system, const Island& island, Columns& lambda,
                                        ConstraintForces& forces) {
    const auto termination = budget_.limits(island, usual, Budget::Take::rest);
    if (bench.threads) bench.runs_of.find(island);
    Outcome outcome = outcome_of(island);
    const solvers::SolveCount count =
        find_better(bench, termination, system, island, nullptr, lambda, forces, outcome);
    outcome.solved = larger(outcome.residuals) <= usual.tolerance_high;
    note(island, outcome, count);
    return count;
}

// Starts from forces with outcome.residuals. Forces outside their bounds cannot be a solution, so they are clamped
// first.
solvers::SolveCount IslandSolver::find_better(Bench& bench, const solvers::Termination& termination,
                                              const SystemEquation& system, const Island& island,
                                              Columns* first_guess, Columns& lambda, ConstraintForces& forces,
                                              Outcome& outcome) {
    if (clamp(system, island, lambda, bench.threads))
        outcome.residuals = measure(system, island, lambda, forces, bench);
    save(island, lambda, bench);
    solvers::SolveCount count = bench.solver->solve(system, island, termination, lambda);
    if (termination.iterations == 0 && has_no_answer(count)) {
        outcome.unfinished = true;
        return count;
    }
    count.iterations = std::max(1, count.iterations);
    Residuals found = measure(system, island, lambda, forces, bench);
    if (larger(found) > termination.tolerance_low) {
        outcome.refused = guard(system, island, outcome.residuals, first_guess, lambda, forces, bench, found);
    }
    outcome.residuals = found;
    outcome.contradicts = count.contradicts;
    outcome.exhausted = count.exhausted;
    count.exact = count.exact && !outcome.refused;
    return count;
}

void IslandSolver::note(const Island& island, const Outcome& outcome, const solvers::SolveCount& count) {
    warm_start_.solved(island, count, outcome.outdated);
    budget_.spent(island, count, outcome.outlook);
    for (const int body : island.bodies) outcomes_[static_cast<std::size_t>(body)] = outcome;
}

void IslandSolver::find_forces(const SystemEquation& system, const Island& island, const Columns& lambda,
                               ConstraintForces& forces, const Bench& bench) {
    const auto find = [&](Eigen::Index column, std::vector<Vector6>& of_column) {
        if (bench.threads) {
            constraint_forces(system, island, bench.runs_of, lambda, column, *bench.threads, of_column);
        } else {
            constraint_forces(system, island, lambda, column, of_column);
        }
    };
    find(0, forces.moving);
    if (island.columns == 2) find(1, forces.lasting);
}

IslandSolver::Residuals IslandSolver::measure(const SystemEquation& system, const Island& island,
                                              const Columns& lambda, ConstraintForces& forces, Bench& bench) {
    find_forces(system, island, lambda, forces, bench);
    Residuals residuals{};
    residuals[0] = island_residual(system, island, lambda, 0, forces.moving, bench.velocities, bench.threads);
    if (island.columns == 2) {
        residuals[1] = island_residual(system, island, lambda, 1, forces.lasting, bench.velocities, bench.threads);
    }
    return residuals;
}

// Whether forces kept from earlier steps are wrong because of a new force; uses the state left by measure(). An
// arriving body does not outdate the forces among the bodies that it meets.
bool IslandSolver::is_outdated(const SystemEquation& system, const Island& island, const Columns& lambda,
                               const solvers::Termination& usual, const Bench& bench) const {
    if (!warm_start_.begins_with_kept(island)) return false;
    const auto is_kept = [&](int number) {
        return number >= island.movable() ||
               warm_start_.kept_steps(island.bodies[static_cast<std::size_t>(number)]) > 0;
    };
    const Eigen::Index column = island.columns - 1;
    RowResiduals residuals(system, lambda, column);
    for (const RowRun& run : island.runs) {
        if (!is_kept(run.a) || !is_kept(run.b)) continue;
        const Vector6& of_a = bench.velocities[static_cast<std::size_t>(run.a)];
        const Vector6& of_b = bench.velocities[static_cast<std::size_t>(run.b)];
        for (int j = run.begin; j < run.end; ++j) {
            const ConstraintRow& row = system.rows[static_cast<std::size_t>(j)];
            const double w = row.jacobian.a.dot(of_a) + row.jacobian.b.dot(of_b) - system.b(j, column) +
                             soft_part(row, lambda, j, column);
            if (residuals.next(j, w) > WarmStart::of_new_force(usual)) return true;
        }
    }
    return false;
}

// Residuals at zero forces: w = -b, and bounds contain zero or their nearest value to it is used.
IslandSolver::Residuals IslandSolver::of_no_forces(const SystemEquation& system, const Island& island) const {
    Residuals residuals{};
    each_force(island, [&](Eigen::Index j, Eigen::Index column) {
        const double diagonal = system.diagonal[j];
        if (diagonal <= 0.0) return;
        const Bounds& bounds = system.rows[static_cast<std::size_t>(j)].bounds;
        if (column > 0 && !bounds.in_momenta) return;
        const auto wanted = [&](Eigen::Index row) {
            return bounds.of_row < 0 ? system.b(row, column) / diagonal : 0.0;
        };
        double moved = std::abs(std::min(std::max(wanted(j), bounds.c_min), bounds.c_max));
        if (bounds.disc == Disc::second) {
            moved = std::min(std::hypot(wanted(j - 1), wanted(j)), bounds.c_max);
        }
        double& largest = residuals[static_cast<std::size_t>(column)];
        largest = std::max(largest, system.dt * diagonal * moved);
    });
    return residuals;
}

void IslandSolver::save(const Island& island, const Columns& lambda, Bench& bench) {
    const auto columns = static_cast<std::size_t>(island.columns);
    bench.saved.resize(columns * static_cast<std::size_t>(island.rows));
    share(bench.threads, island.runs.size(), runs_of_a_part, [&](std::size_t begin, std::size_t end) {
        std::size_t number = columns * static_cast<std::size_t>(island.runs[begin].first);
        each_force(island.runs.subspan(begin, end - begin), island.columns,
                   [&](Eigen::Index j, Eigen::Index column) { bench.saved[number++] = lambda(j, column); });
    });
}

// Takes for each column the best of the found forces, those before the solve, the first warm start of the step, and
// zero forces. Returns whether any column was replaced.
bool IslandSolver::guard(const SystemEquation& system, const Island& island, const Residuals& guessed,
                         Columns* first_guess, Columns& lambda, ConstraintForces& forces, Bench& bench,
                         Residuals& found) {
    const Residuals nothing = of_no_forces(system, island);
    if (first_guess) clamp(system, island, *first_guess, bench.threads);
    const Residuals first = first_guess ? measure(system, island, *first_guess, forces, bench) : guessed;
    bool refused = false;
    for (Eigen::Index column = 0; column < island.columns; ++column) {
        const auto c = static_cast<std::size_t>(column);
        const double best = std::min({guessed[c], first[c], nothing[c]});
        if (found[c] <= best) continue;
        refused = true;
        found[c] = best;
        std::size_t number = 0;
        each_force(island, [&](Eigen::Index j, Eigen::Index of) {
            const double saved = bench.saved[number++];
            if (of != column) return;
            lambda(j, column) = best == guessed[c] ? saved : best == nothing[c] ? 0.0 : (*first_guess)(j, column);
        });
    }
    if (refused) copy_to_last(island, lambda);
    if (refused || first_guess) find_forces(system, island, lambda, forces, bench);
    return refused;
}

void IslandSolver::take_memory(std::vector<Memory>& memory) const {
    memory.clear();
    for (std::size_t i = 0; i < warm_start_.memory().size(); ++i) {
        memory.push_back({warm_start_.memory()[i], budget_.debts()[i]});
    }
}

void IslandSolver::set_memory(std::span<const Memory> memory) {
    std::vector<WarmStart::Memory> forces;
    std::vector<Budget::Debt> debts;
    for (const Memory& own : memory) {
        forces.push_back(own.forces);
        debts.push_back(own.debt);
    }
    warm_start_.set_memory(forces);
    budget_.set_debts(debts);
}

}  // namespace pushfactor::engine
