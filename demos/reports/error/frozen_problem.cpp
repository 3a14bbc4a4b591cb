#include "demos/reports/error/frozen_problem.h"

#include "engine/world.h"

#include <cmath>

namespace pushfactor::demos::reports::error {

namespace {

using engine::ConstraintRow;

template <typename Numbers>
Json numbers_of(const Numbers& numbers) {
    Json array = Json::array();
    for (const double number : numbers.reshaped()) array.push_back(number);
    return array;
}

Json bound_json(double bound) {
    return std::isfinite(bound) ? Json(bound) : Json(nullptr);
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
    json["rows"] = Json::array();
    for (Eigen::Index j = 0; j < system_.row_count(); ++j) {
        const ConstraintRow& row = rows_[static_cast<std::size_t>(j)];
        Json entry{{"body_a", row.body_a},
                   {"body_b", row.body_b},
                   {"j_a", numbers_of(row.jacobian.a)},
                   {"j_b", numbers_of(row.jacobian.b)},
                   {"c_min_n", bound_json(row.bounds.c_min)},
                   {"c_max_n", bound_json(row.bounds.c_max)}};
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

}  // namespace pushfactor::demos::reports::error
