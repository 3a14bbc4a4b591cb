#include "demos/reports/error/frozen.h"

#include "demos/runs/session.h"
#include "demos/scenes/families/family.h"
#include "engine/solvers/solver.h"
#include "engine/world.h"

#include <fmt/format.h>

#include <algorithm>

namespace pushfactor::demos::reports::error {

namespace {

using engine::ConstraintRow;

template <typename Numbers>
Json numbers_of(const Numbers& numbers) {
    Json array = Json::array();
    for (const double number : numbers.reshaped()) array.push_back(number);
    return array;
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

FrozenProblem::FrozenProblem(std::string name, std::vector<ConstraintRow> rows, engine::SystemEquation system,
                             engine::Columns guess)
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
    // The paper's friction bound makes the problem convex, with a unique solution to compare with. No cube of a
    // stack is exactly above the next: symmetry would hide the behaviour of Jacobi.
    const OptionTexts::value_type convex{"friction-model", "paper"};
    // Landing: the step in which the topmost cube, which falls through all gaps, meets the one below it. Settled:
    // after some time with many iterations, before a tall stack leans. Chains have enough substeps to hold.
    const OptionTexts::value_type apart{"gap", "0.1"}, touching{"gap", "-0.0001"}, many{"iterations", "200"},
        heavy{"end-mass", "1000"};
    std::vector<FrozenMoment> moments{
        {"stack of 5, landing", "stack", {{"count", "5"}, apart, {"seconds", "0.32"}}},
        {"stack of 5, settled", "stack", {{"count", "5"}, touching, many, {"seconds", "2"}}},
        {"funnel of 20", "funnel", {{"count", "20"}, {"seconds", "5"}, convex}},
        {"pendulum grid", "pendulum-grid", {{"seconds", quick ? "1" : "5"}, convex}},
        {"chain of 20, end 1000 times heavier",
         "chain",
         {{"links", "20"}, heavy, {"substeps", "32"}, {"seconds", "1"}}},
        {"column of 10 spheres", "sphere_column", {{"seconds", "0.02"}}}};
    const std::vector<FrozenMoment> more{
        {"stack of 20, landing", "stack", {{"count", "20"}, apart, {"seconds", "0.64"}}},
        {"stack of 100, landing", "stack", {{"count", "100"}, apart, {"seconds", "1.42"}}},
        {"stack of 20, settled", "stack", {{"count", "20"}, touching, many, {"seconds", "2"}}},
        {"stack of 100, settled", "stack", {{"count", "100"}, touching, many, {"seconds", "0.5"}}},
        {"chain of 5, end 1000 times heavier",
         "chain",
         {{"links", "5"}, heavy, {"substeps", "16"}, {"seconds", "1"}}},
        {"funnel of 200", "funnel", {{"count", "200"}, {"seconds", "5"}, convex}}};
    if (!quick) moments.insert(moments.end(), more.begin(), more.end());
    for (FrozenMoment& moment : moments) {
        if (moment.scene == "stack")
            moment.options.insert(moment.options.end(), {{"jitter", "0.01"}, {"seed", "1"}, convex});
        // Solvers get the system and the cached forces of a whole step.
        moment.options.emplace_back("scheme", "whole");
    }
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
                engine::Columns lambda = warm ? problem.guess() : problem.zero();
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

std::string key_of(const FrozenMoment& moment, bool quick) {
    return fmt::format("error: frozen, {}: {}{}", moment.name, run_key(moment.scene, moment.options),
                       quick ? "; few iterations" : "");
}

Pieces frozen_pieces(const std::vector<FrozenMoment>& moments, bool quick) {
    Pieces pieces;
    for (const FrozenMoment& moment : moments) {
        pieces.push_back({key_of(moment, quick), [moment, quick](const StopCheck& check) {
                              const FrozenProblem problem = freeze(moment, check);
                              return Json{{"rows", problem.system().row_count()},
                                          {"columns", problem.system().column_count()},
                                          {"lines", exact_rows(solve_frozen(problem, quick))}};
                          }});
    }
    return pieces;
}

std::vector<WorkLine> lines_of(const std::vector<std::vector<std::string>>& lines) {
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

}  // namespace pushfactor::demos::reports::error
