#include "engine/step/island_solver.h"

#include "engine/base/constants.h"
#include "engine/step/choice.h"

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

// Adds `factor` times what the rows of loops give way to under `lambda` to their targets.
void shift_targets(const Island& island, const Columns& lambda, double factor, SystemEquation& system) {
    each_force(island, [&](Eigen::Index j, Eigen::Index column) {
        const ConstraintRow& row = system.rows[static_cast<std::size_t>(j)];
        if (is_of_loop(row)) system.b(j, column) += factor * soft_part(row, lambda, j, column);
    });
}

// Of an overlap, small steps of `h` [s] leave what its load compresses it by (find_left() in aim.h). A solution of
// the whole step leaves as much: else what rests after small steps would be solved again for ever.
void leave_compressed(const Island& island, const Columns& lambda, double h, SystemEquation& system) {
    const Eigen::Index last = lambda.cols() - 1;
    each_force(island.runs, 1, [&](Eigen::Index j, Eigen::Index) {
        const ConstraintRow& row = system.rows[static_cast<std::size_t>(j)];
        if (row.bounds.c_min < 0.0 || !holds_a_place(row) || !(row.push.correcting > 0.0)) return;
        const double compressed = system.diagonal[j] * lambda(j, last) * h * h / constants::small_steps::stiffness;
        const double most = std::max(0.0, -row.error - compressed) / system.dt;
        system.b(j, 0) = system.b(j, last) + std::min(row.push.correcting, most) / system.dt;
        if (!system.detours.empty())
            system.b(j, 0) -= acceleration_along(system, static_cast<std::size_t>(j), system.detours);
    });
}

// Whether any row closes a loop; and whether one of a joint does: a contact opens where its force would be wrong.
struct Loops {
    bool any = false, of_joints = false;
};

Loops loops_of(const SystemEquation& system, const Island& island) {
    Loops loops;
    if (!island.has(RowDigest::joins) || !island.has(RowDigest::soft)) return loops;
    each_force(island.runs, 1, [&](Eigen::Index j, Eigen::Index) {
        const ConstraintRow& row = system.rows[static_cast<std::size_t>(j)];
        if (!is_of_loop(row)) return;
        loops.any = true;
        loops.of_joints = loops.of_joints || row.label.kind == RowKind::joint;
    });
    return loops;
}

double larger(const std::array<double, 2>& residuals) {
    return std::max(residuals[0], residuals[1]);
}

}  // namespace

void IslandSolver::begin(std::size_t bodies, std::span<const int> awake) {
    outcomes_.resize(bodies);
    for (const int body : awake) outcomes_[static_cast<std::size_t>(body)] = {};
}

solvers::SolveCount IslandSolver::solve(Bench& bench, const solvers::Termination& usual, SystemEquation& system,
                                        std::span<const Body> bodies, const Island& island, Columns* first_guess,
                                        Columns& lambda, ConstraintForces& forces) {
    const bool fixed_number = usual.tolerance_high <= 0.0;
    const bool divides = bench.small_steps && choice::divides(island);
    Outcome outcome;
    if (divides && fixed_number) {
        outcome.unfinished = true;
        note(island, outcome);
        return {};
    }
    if (bench.threads) bench.runs_of.find(island);
    if (fixed_number) {
        const solvers::SolveCount count = bench.solver->solve(system, island, usual, lambda);
        find_forces(system, island, lambda, forces, bench);
        outcome.method = count.iterations > 0 ? Method::swept : Method::kept;
        note(island, outcome);
        return count;
    }
    solvers::SolveCount count;
    if (divides && island.columns == 2) {
        const SmallSteps::Division division = bench.small_steps->division_of(system, bodies, island);
        leave_compressed(island, lambda, system.dt / division.steps, system);
    }
    const Loops loops = loops_of(system, island);
    if (loops.any)
        shift_targets(island, lambda, 1.0, system);  // the last forces were found with targets like these
    outcome.residuals = measure(system, island, lambda, forces, bench);
    if (!choice::will_do(larger(outcome.residuals), usual, system, bodies, island)) {
        if (loops.any) {
            shift_targets(island, lambda, -1.0, system);
            outcome.residuals = measure(system, island, lambda, forces, bench);
        }
        solvers::Termination own = usual;
        const std::span<const double> residuals(outcome.residuals.data(), static_cast<std::size_t>(island.columns));
        const choice::Worth worth = choice::worth_of(system, bodies, island, residuals, has_forces(island, lambda),
                                                     divides, loops.of_joints);
        own.worth = worth.multiply_adds;
        own.factorisations = worth.factorisations;
        own.at_least = worth.at_least;
        if (divides) {
            own.iterations = worth.sweeps;
            own.will_do = choice::good_residual(system.dt, bodies, island);
        }
        count = find_better(bench, own, system, island, first_guess, lambda, forces, outcome);
        if (outcome.method == Method::exact && loops.any)
            lessen(bench, own, system, island, lambda, forces, outcome, count);
    }
    note(island, outcome);
    count.multiply_adds += 12.0 * island.rows * island.columns;
    return count;
}

// Where rows close a loop, no force reaches a part of their targets t, and forces for it move nothing: they are
// what the softness s gives way to. With targets t - s y of the first forces y, that part is left out, but what
// carries load gives way twice as much; with t - s y + 2 s z of the second forces z it gives way by 3 (s / A)^2
// only.
void IslandSolver::lessen(Bench& bench, const solvers::Termination& termination, SystemEquation& system,
                          const Island& island, Columns& lambda, ConstraintForces& forces, Outcome& outcome,
                          solvers::SolveCount& count) {
    for (const double share : {-1.0, 2.0}) {
        save(island, lambda, bench);
        shift_targets(island, lambda, share, system);
        const solvers::SolveCount again = bench.solver->solve(system, island, termination, lambda);
        count.iterations += again.iterations;
        count.multiply_adds += again.multiply_adds;
        if (again.exact) continue;
        std::size_t number = 0;
        each_force(island, [&](Eigen::Index j, Eigen::Index column) { lambda(j, column) = bench.saved[number++]; });
        copy_to_last(island, lambda);
        shift_targets(island, lambda, -share, system);
        break;
    }
    outcome.residuals = measure(system, island, lambda, forces, bench);
}

// The residual left by small steps is not compared with a tolerance: the next small step reduces it.
solvers::SolveCount IslandSolver::take_small_steps(Bench& bench, const SystemEquation& system,
                                                   std::span<const Body> bodies, const Island& island,
                                                   const RowSources& sources, Columns& lambda,
                                                   ConstraintForces& forces, std::span<Lambda> ending) {
    SmallSteps& small_steps = *bench.small_steps;
    const SmallSteps::Division division = small_steps.division_of(system, bodies, island);
    const solvers::SolveCount count =
        small_steps.solve(system, bodies, island, division, sources, bench.threads, lambda, forces, ending);
    note(island, {.method = Method::in_small_steps, .residuals = {small_steps.residual(), small_steps.residual()}});
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
    if (termination.iterations == 0 && !count.exact && !count.contradicts) {
        outcome.unfinished = true;
        return count;
    }
    count.iterations = std::max(1, count.iterations);
    Residuals found = measure(system, island, lambda, forces, bench);
    const double enough = std::max(termination.tolerance_high, termination.will_do);
    if (termination.will_do > 0.0 && !count.exact && !count.contradicts && larger(found) > enough) {
        outcome.unfinished = true;
        return count;
    }
    bool refused = false;
    if (larger(found) > termination.tolerance_low) {
        refused = guard(system, island, outcome.residuals, first_guess, lambda, forces, bench, found);
    }
    outcome.method = count.exact && !refused ? Method::exact : Method::swept;
    outcome.residuals = found;
    outcome.contradicts = count.contradicts;
    outcome.solved = larger(found) <= termination.tolerance_high;
    return count;
}

// Small steps count only if they came last: they leave two forces per body and guesses of their own, which a later
// solution does not.
void IslandSolver::note(const Island& island, Outcome outcome) {
    for (const int body : island.bodies) {
        const Method before = outcomes_[static_cast<std::size_t>(body)].method;
        if (before != Method::in_small_steps) outcome.method = std::max(outcome.method, before);
    }
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
            moved = std::min(elementary::hypot(wanted(j - 1), wanted(j)), bounds.c_max);
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

}  // namespace pushfactor::engine
