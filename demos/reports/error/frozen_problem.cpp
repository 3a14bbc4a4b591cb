#include "demos/reports/error/frozen_problem.h"

#include "demos/text/errors.h"
#include "demos/text/json_file.h"
#include "demos/text/json_reader.h"
#include "engine/world.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace pushfactor::demos::reports::error {

namespace {

using engine::ConstraintRow;
using engine::Matrix3;
using engine::Vector6;

constexpr int format_version = 1;
constexpr double infinite_force = std::numeric_limits<double>::infinity();  // N

template <typename Numbers>
Json numbers_of(const Numbers& numbers) {
    Json array = Json::array();
    for (const double number : numbers.reshaped()) array.push_back(number);
    return array;
}

// Row by row.
Json matrix_json(const Matrix3& matrix) {
    return numbers_of(matrix.transpose());
}

Json bound_json(double bound) {
    return std::isfinite(bound) ? Json(bound) : Json(nullptr);
}

Matrix3 read_matrix(const JsonReader& json) {
    const std::vector<double> n = json.numbers(9, "nine numbers");
    return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(n.data());
}

Vector6 read_six(const JsonReader& json) {
    return Eigen::Map<const Vector6>(json.numbers(6, "six numbers").data());
}

double read_bound(const JsonReader& json, double without) {
    if (json.json().is_null()) return without;
    return json.number(std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max());
}

int read_index(const JsonReader& json, std::size_t count) {
    const double number = json.number(0, static_cast<double>(count) - 1.0);
    if (number != std::floor(number)) json.refuse("a whole number");
    return static_cast<int>(number);
}

// `before` is the previous row, which may be the first of a disc.
engine::Disc read_disc(const JsonReader& json, const ConstraintRow& row, const ConstraintRow* before) {
    const bool begun = before && before->bounds.disc == engine::Disc::first;
    const std::string disc = json.has("disc") ? json.at("disc").string() : "";
    if (disc == "first" && !begun) return engine::Disc::first;
    if (begun && disc != "second") json.refuse("a row with \"disc\": \"second\" after one with \"first\"");
    if (!begun && !disc.empty()) json.at("disc").refuse("\"first\", and \"second\" in the row after it");
    if (!begun) return engine::Disc::none;
    const bool same = row.body_a == before->body_a && row.body_b == before->body_b &&
                      row.bounds.of_row == before->bounds.of_row && row.bounds.c_max == before->bounds.c_max;
    if (!same) json.refuse("the bodies and the bounds of the first row of the disc");
    return engine::Disc::second;
}

ConstraintRow read_row(const JsonReader& json, std::size_t bodies, std::span<const ConstraintRow> before) {
    const std::size_t index = before.size();
    ConstraintRow row;
    row.body_a = read_index(json.at("body_a"), bodies);
    row.body_b = read_index(json.at("body_b"), bodies);
    row.jacobian = {read_six(json.at("j_a")), read_six(json.at("j_b"))};
    row.bounds.c_min = read_bound(json.at("c_min_n"), -infinite_force);
    row.bounds.c_max = read_bound(json.at("c_max_n"), infinite_force);
    if (json.has("of_row")) row.bounds.of_row = read_index(json.at("of_row"), index);
    row.bounds.disc = read_disc(json, row, before.empty() ? nullptr : &before.back());
    if (json.has("in_momenta")) row.bounds.in_momenta = json.at("in_momenta").boolean();
    return row;
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

FrozenProblem::FrozenProblem(std::string name, std::vector<ConstraintRow> rows, engine::SystemEquation system)
    : name_(std::move(name)), rows_(std::move(rows)), system_(std::move(system)) {
    system_.rows = rows_;
    guess_ = engine::Columns::Zero(system_.row_count(), system_.column_count());
    weigh_rows(system_);
}

FrozenProblem::FrozenProblem(const std::filesystem::path& file) {
    const Json document = read_json_file(file, "frozen problem " + file.string());
    const JsonReader json(document, file.string());
    json.require_object();
    if (json.at("version").number(0, 1e9) != format_version)
        json.at("version").refuse(std::to_string(format_version));
    name_ = json.at("name").string();
    system_.dt = json.at("dt_s").positive();
    const std::vector<JsonReader> bodies = json.at("bodies").elements();
    for (const JsonReader& body : bodies) {
        const double inverse_mass = body.at("inverse_mass_per_kg").number(0, std::numeric_limits<double>::max());
        system_.awake.push_back(static_cast<int>(system_.awake.size()));
        system_.inverse_mass.push_back({.linear = inverse_mass,
                                        .linear_root = std::sqrt(inverse_mass),
                                        .angular = read_matrix(body.at("inverse_inertia_per_kg_m2")),
                                        .angular_root = read_matrix(body.at("inverse_inertia_root"))});
        system_.free_acceleration.push_back(read_six(body.at("free_acceleration")));
    }
    const std::vector<JsonReader> rows = json.at("rows").elements();
    const auto count = static_cast<Eigen::Index>(rows.size());
    const std::size_t columns = rows.empty() ? 1 : rows.front().at("b_m_per_s2").elements().size();
    if (columns != 1 && columns != 2) rows.front().at("b_m_per_s2").refuse("one or two numbers");
    const std::string one_a_column = "one number per column";
    system_.b.resize(count, static_cast<Eigen::Index>(columns));
    guess_.resizeLike(system_.b);
    for (Eigen::Index j = 0; j < count; ++j) {
        const JsonReader& row = rows[static_cast<std::size_t>(j)];
        rows_.push_back(read_row(row, bodies.size(), rows_));
        const std::vector<double> b = row.at("b_m_per_s2").numbers(columns, one_a_column);
        const std::vector<double> guess = row.at("guess_n").numbers(columns, one_a_column);
        for (std::size_t c = 0; c < columns; ++c) {
            system_.b(j, static_cast<Eigen::Index>(c)) = b[c];
            guess_(j, static_cast<Eigen::Index>(c)) = guess[c];
        }
        rows_.back().guess = {guess.front(), guess.back()};
    }
    if (!rows_.empty() && rows_.back().bounds.disc == engine::Disc::first) {
        rows.back().refuse("a row with \"disc\": \"second\" after it");
    }
    system_.rows = rows_;
    weigh_rows(system_);
}

FrozenProblem::FrozenProblem(FrozenProblem&& other) noexcept
    : name_(std::move(other.name_)),
      rows_(std::move(other.rows_)),
      system_(std::move(other.system_)),
      guess_(std::move(other.guess_)) {
    system_.rows = rows_;
}

std::string FrozenProblem::text() const {
    Json json{{"version", format_version}, {"name", name_}, {"dt_s", system_.dt}};
    json["bodies"] = Json::array();
    for (std::size_t i = 0; i < system_.inverse_mass.size(); ++i) {
        const engine::InverseMass& body = system_.inverse_mass[i];
        json["bodies"].push_back({{"inverse_mass_per_kg", body.linear},
                                  {"inverse_inertia_per_kg_m2", matrix_json(body.angular)},
                                  {"inverse_inertia_root", matrix_json(body.angular_root)},
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
