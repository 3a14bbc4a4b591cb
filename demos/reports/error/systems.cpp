// Systems of one step: frozen problems; and converged forces, by the active set method, with the error against
// them.
#include "demos/reports/error/error.h"
#include "demos/scenes/families/family.h"
#include "engine/solvers/solver.h"
#include "engine/world.h"

#include <fmt/format.h>

#include <cmath>

namespace pushfactor::demos::reports::error {

namespace {

using engine::Columns;
using engine::ConstraintRow;
using engine::SystemEquation;
using engine::Vector6;

template <typename Numbers>
Json numbers_of(const Numbers& numbers) {
    const auto all = numbers.reshaped();
    return std::vector<double>(all.begin(), all.end());
}

constexpr std::size_t most_rows_of_dense = 200;

Choices member_of(const std::string& family, int seed, const families::GivenValues& values) {
    Choices choices;
    choices.settings = preset_settings("default");
    choices.settings.rest = false;
    choices.description =
        draw_member(*families::find_family(family), {.seed = seed, .given = values}).prospect.scene;
    return choices;
}

constexpr double converged_residual = 1e-10;  // m/s, natural map

// x^T A x of one column.
double energy(const SystemEquation& system, const Columns& x, Eigen::Index column) {
    std::vector<Vector6> forces;
    constraint_forces(system, x, column, forces);
    double sum = 0.0;
    for (std::size_t i = 0; i < forces.size(); ++i) {
        sum += forces[i].dot(accelerate(system.inverse_mass[i], forces[i]));
    }
    return sum;
}

// A, column by column.
engine::MatrixX dense_matrix(const SystemEquation& system) {
    const Eigen::Index count = system.row_count();
    engine::MatrixX A(count, count);
    const Columns units = Columns::Identity(count, count);
    std::vector<Vector6> forces;
    for (Eigen::Index i = 0; i < count; ++i) {
        constraint_forces(system, units, i, forces);
        for (Eigen::Index j = 0; j < count; ++j) {
            A(j, i) = acceleration_along(system, static_cast<std::size_t>(j), forces);
        }
    }
    return A;
}

// The bounds of row `j` with all other forces fixed: for a disc, the chord through it.
engine::Interval range_of(const SystemEquation& system, const Columns& lambda, Eigen::Index j,
                          Eigen::Index column) {
    const engine::ConstraintRow& row = system.rows[static_cast<std::size_t>(j)];
    const engine::Interval bounds = bounds_of(row, lambda, column);
    if (row.bounds.disc == engine::Disc::none) return bounds;
    const double other = lambda(row.bounds.disc == engine::Disc::first ? j + 1 : j - 1, column);
    const double half = std::sqrt(std::max(0.0, bounds.high * bounds.high - other * other));
    return {-half, half};
}

// Adds a share of `change`, at most `most`, to the free rows of a column, up to the first that reaches a bound.
// Returns the share; infinity, and no change, if `most` is infinite and no row reaches a bound.
double move(const SystemEquation& system, const std::vector<Eigen::Index>& free, const engine::VectorX& change,
            double most, Columns& lambda, Eigen::Index column) {
    const auto way = [&](std::size_t k) {
        const double speed = change[static_cast<Eigen::Index>(k)];
        const auto [low, high] = range_of(system, lambda, free[k], column);
        const double bound = speed > 0.0 ? high : low;
        return std::pair{bound, speed == 0.0 ? engine::infinity : (bound - lambda(free[k], column)) / speed};
    };
    double share = most;
    for (std::size_t k = 0; k < free.size(); ++k) share = std::min(share, way(k).second);
    if (share == engine::infinity) return share;
    for (std::size_t k = 0; k < free.size(); ++k) {
        const auto [bound, reached] = way(k);
        double& value = lambda(free[k], column);
        // Exactly on the bound, without rounding.
        value = reached <= share ? bound : value + share * change[static_cast<Eigen::Index>(k)];
    }
    for (const Eigen::Index j : free) clamp_force(system.rows, j, column, lambda);
    return share;
}

// Active set method: solves A lambda = b for the rows between their bounds; a row that reaches a bound on the way
// stays there, and the rest is solved again without it. A is rank-deficient where boxes touch, so the minimum-norm
// change is taken; forces along an error that remains grow until a row reaches a bound.
void finish_free_rows(const SystemEquation& system, const engine::MatrixX& A, Columns& lambda,
                      Eigen::Index column) {
    for (Eigen::Index turn = 0; turn < 2 * lambda.rows(); ++turn) {
        std::vector<Eigen::Index> free;
        for (Eigen::Index j = 0; j < lambda.rows(); ++j) {
            const auto [low, high] = range_of(system, lambda, j, column);
            if (lambda(j, column) > low && lambda(j, column) < high && system.diagonal[j] > 0.0) free.push_back(j);
        }
        if (free.empty()) return;
        const engine::VectorX all = system.b.col(column) - A * lambda.col(column);
        const engine::VectorX error = all(free);
        const engine::MatrixX A_free = A(free, free);
        const engine::VectorX change = A_free.completeOrthogonalDecomposition().solve(error);
        if (move(system, free, change, 1.0, lambda, column) < 1.0) continue;
        const engine::VectorX unmet = error - A_free * change;
        if (system.dt * unmet.cwiseAbs().maxCoeff() < 0.1 * converged_residual) return;
        if (move(system, free, unmet, engine::infinity, lambda, column) == engine::infinity) return;
    }
}

}  // namespace

FrozenProblem::FrozenProblem(std::string name, const engine::World& world)
    : name_(std::move(name)), rows_(world.rows().begin(), world.rows().end()), system_(world.system()) {
    system_.rows = rows_;
    guess_.resize(system_.row_count(), system_.column_count());
    for (Eigen::Index j = 0; j < guess_.rows(); ++j) {
        const engine::Lambda& guess = rows_[static_cast<std::size_t>(j)].guess;
        guess_(j, 0) = guess.first;
        guess_(j, guess_.cols() - 1) = guess.last;
    }
}

FrozenProblem::FrozenProblem(std::string name, std::vector<ConstraintRow> rows, SystemEquation system,
                             Columns guess)
    : name_(std::move(name)), rows_(std::move(rows)), system_(std::move(system)), guess_(std::move(guess)) {
    system_.rows = rows_;
    weigh_rows(system_);
}

std::string FrozenProblem::text() const {
    Json json{{"version", frozen_version}, {"name", name_}, {"dt_s", system_.dt}};
    json["bodies"] = Json::array();
    for (std::size_t i = 0; i < system_.inverse_mass.size(); ++i) {
        const engine::InverseMass& body = system_.inverse_mass[i];
        json["bodies"].push_back({{"inverse_mass_per_kg", body.linear},
                                  {"inverse_inertia_per_kg_m2", numbers_of(body.angular.transpose())},
                                  {"inverse_inertia_root", numbers_of(body.angular_root.transpose())},
                                  {"free_acceleration", numbers_of(system_.free_acceleration[i])}});
    }
    json["rows"] = Json::array();  // infinite bounds are written as null
    for (Eigen::Index j = 0; j < system_.row_count(); ++j) {
        const ConstraintRow& row = rows_[static_cast<std::size_t>(j)];
        Json entry{{"body_a", row.body_a},
                   {"body_b", row.body_b},
                   {"j_a", numbers_of(row.jacobian.a)},
                   {"j_b", numbers_of(row.jacobian.b)},
                   {"c_min_n", row.bounds.c_min},
                   {"c_max_n", row.bounds.c_max}};
        if (row.bounds.of_row >= 0) entry["of_row"] = row.bounds.of_row;
        if (row.bounds.disc != engine::Disc::none) {
            entry["disc"] = row.bounds.disc == engine::Disc::first ? "first" : "second";
        }
        if (!row.bounds.in_momenta) entry["in_momenta"] = false;
        entry["b_m_per_s2"] = numbers_of(system_.b.row(j));
        entry["guess_n"] = numbers_of(guess_.row(j));
        json["rows"].push_back(entry);
    }
    return json_text(json, 1);
}

std::vector<FrozenMoment> hard_moments(bool quick) {
    std::vector<FrozenMoment> moments;
    const auto add = [&moments](const char* name, const char* scene, const std::string& text) {
        // Solvers get the system and the cached forces of a whole step.
        moments.push_back({name, scene, options(text + " scheme=whole")});
    };
    // The paper's friction bound makes the problem convex, with a unique solution to compare with. No cube of a
    // stack is exactly above the next: symmetry would hide the behaviour of Jacobi.
    const std::string convex = " friction-model=paper", stack = " jitter=0.01 seed=1" + convex;
    // Landing: the step in which the topmost cube, which falls through all gaps, meets the one below it. Settled:
    // after some time with many iterations, before a tall stack leans. Chains have enough substeps to hold.
    add("stack of 5, landing", "stack", "count=5 gap=0.1 seconds=0.32" + stack);
    add("stack of 5, settled", "stack", "count=5 gap=-0.0001 iterations=200 seconds=2" + stack);
    add("funnel of 20", "funnel", "count=20 seconds=5" + convex);
    add("pendulum grid", "pendulum-grid", (quick ? "seconds=1" : "seconds=5") + convex);
    add("chain of 20, end 1000 times heavier", "chain", "links=20 end-mass=1000 substeps=32 seconds=1");
    add("column of 10 spheres", "sphere_column", "seconds=0.02");
    if (quick) return moments;
    add("stack of 20, landing", "stack", "count=20 gap=0.1 seconds=0.64" + stack);
    add("stack of 100, landing", "stack", "count=100 gap=0.1 seconds=1.42" + stack);
    add("stack of 20, settled", "stack", "count=20 gap=-0.0001 iterations=200 seconds=2" + stack);
    add("stack of 100, settled", "stack", "count=100 gap=-0.0001 iterations=200 seconds=0.5" + stack);
    add("chain of 5, end 1000 times heavier", "chain", "links=5 end-mass=1000 substeps=16 seconds=1");
    add("funnel of 200", "funnel", "count=200 seconds=5" + convex);
    return moments;
}

std::vector<ContactMoment> contact_moments(bool quick) {
    constexpr double early = 0.5, late = 2.0;  // s: while things fall or meet, and when most of them lie
    std::vector<ContactMoment> moments;
    for (int i = 1; i <= (quick ? 1 : 5); ++i) {
        const std::string number = std::to_string(i);
        for (const double seconds : quick ? std::vector{early} : std::vector{early, late}) {
            const auto add = [&](const std::string& kind, Choices choices) {
                // A whole step is one system; the cone is Coulomb's law.
                choices.settings.scheme = Scheme::whole;
                choices.settings.friction_model = FrictionModel::cone;
                choices.settings.seconds = seconds;
                moments.push_back({fmt::format("{}_{}_at_{}s", kind, i, seconds), std::move(choices)});
            };
            add("stack", run_of("stack", {{"count", std::to_string(5 * i)}, {"jitter", "0.01"}, {"seed", number}}));
            add("heap", member_of("mixed", i, {{"count", std::to_string(20 * i)}}));
            add("wall",
                member_of("wall", i, {{"rows", std::to_string(2 + i)}, {"columns", std::to_string(3 + i)}}));
            add("cards", member_of("card-house", i, {{"storeys", number}}));
            add("arch", run_of("arch", {{"voussoirs", std::to_string(5 + 4 * i)}}));
        }
    }
    return moments;
}

FrozenProblem freeze(const FrozenMoment& moment, const StopCheck& check) {
    return freeze(moment.name, run_of(moment.scene, moment.options), check);
}

FrozenProblem freeze(const std::string& name, const Choices& choices, const StopCheck& check) {
    Simulation run(choices);
    play_steps(run, std::max(1L, whole_steps(run.settings())), check);
    return {name, run.scene().world};
}

Table solve_frozen(const FrozenProblem& problem, bool quick) {
    const std::vector<int> iterations =
        quick ? std::vector{1, 5, 25, 100} : std::vector{1, 2, 5, 10, 25, 50, 100, 250, 1000};
    Table table{frozen_columns};
    for (const engine::solvers::SolverEntry& entry : engine::solvers::solver_table()) {
        if (entry.name == "dense" && problem.system().rows.size() > most_rows_of_dense) continue;
        for (const bool warm : {false, true}) {
            for (const int most : iterations) {
                Columns lambda = warm ? problem.guess() : problem.zero();
                // Tolerances of zero: always all iterations.
                const double work =
                    entry.make()->solve(problem.system(), {.iterations = most}, lambda).multiply_adds;
                table.rows.push_back({problem.name(), fmt::format("{}, {}", entry.name, warm ? "warm" : "cold"),
                                      most, natural_residual(problem.system(), lambda), work});
            }
        }
    }
    return table;
}

Piece piece_of(const FrozenMoment& moment, bool quick) {
    return {fmt::format("error: frozen, {}: {}{}", moment.name, run_key(moment.scene, moment.options),
                        quick ? "; few iterations" : ""),
            [moment, quick](const StopCheck& check) {
                const FrozenProblem problem = freeze(moment, check);
                return Json{{"rows", problem.system().row_count()},
                            {"columns", problem.system().column_count()},
                            {"lines", exact_rows(solve_frozen(problem, quick))}};
            }};
}

std::vector<WorkLine> lines_of(const TextTable& lines) {
    std::vector<WorkLine> drawn;
    for (const auto& cells : lines) {
        const std::string &method = cells[1], &iterations = cells[2];
        if (method.starts_with("dense")) continue;
        if (drawn.empty() || drawn.back().name != method) {
            const bool warm = method.ends_with("warm");
            drawn.push_back(
                {.name = method, .colour = colour_of_solver(method), .dash = warm ? 1 : 2, .mark = warm ? 7 : 5});
        }
        drawn.back().points.push_back({std::stod(cells[3]), std::stod(cells[4]), iterations});
    }
    return drawn;
}

std::optional<double> force_error(const SystemEquation& system, const Columns& lambda, const Columns& converged) {
    const Columns difference = lambda - converged;
    std::optional<double> worst;
    for (Eigen::Index column = 0; column < lambda.cols(); ++column) {
        const double whole = energy(system, converged, column);
        if (!(whole > 0.0)) continue;
        worst = std::max(worst.value_or(0.0), std::sqrt(energy(system, difference, column) / whole));
    }
    return worst;
}

std::optional<Columns> converged_forces(const SystemEquation& system, const Columns& guess) {
    Columns answer = guess;
    // Without tolerances: a guess that was kept would be its own reference and have no error.
    const auto converges = [&](const char* solver, int iterations) {
        engine::solvers::make_solver(solver)->solve(system, {.iterations = iterations}, answer);
        return answer.allFinite() && natural_residual(system, answer) <= converged_residual;
    };
    if (converges("direct", 100)) return answer;

    // Sweeps find the active set long before they converge on the remaining linear system: some modes, such as bars
    // that hold each other through contacts, need more than a hundred thousand sweeps.
    answer = guess;
    if (converges("pgs", 500)) return answer;
    const engine::MatrixX A = dense_matrix(system);
    for (int round = 0; round < 40; ++round) {
        for (Eigen::Index column = 0; column < answer.cols(); ++column) {
            finish_free_rows(system, A, answer, column);
        }
        if (natural_residual(system, answer) <= converged_residual || converges("pgs", 25)) return answer;
    }
    return std::nullopt;
}

}  // namespace pushfactor::demos::reports::error
