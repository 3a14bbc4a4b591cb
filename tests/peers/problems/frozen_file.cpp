#include "tests/peers/problems/frozen_file.h"

#include "demos/base/text/json_reader.h"

#include <cmath>
#include <limits>

namespace pushfactor::tests::problems {

namespace {

using demos::Json, demos::JsonReader;
using engine::ConstraintRow;
using engine::Matrix3;
using engine::Vector6;

constexpr double infinite_force = std::numeric_limits<double>::infinity();  // N

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

demos::reports::error::FrozenProblem read_frozen(const std::filesystem::path& file) {
    using demos::reports::error::frozen_version;
    const Json document = demos::read_json_file(file, "frozen problem " + file.string());
    const JsonReader json(document, file.string());
    json.require_object();
    if (json.at("version").number(0, 1e9) != frozen_version)
        json.at("version").refuse(std::to_string(frozen_version));
    const std::string name = json.at("name").string();
    engine::SystemEquation system;
    std::vector<ConstraintRow> made;
    engine::Columns guesses;
    system.dt = json.at("dt_s").positive();
    const std::vector<JsonReader> bodies = json.at("bodies").elements();
    for (const JsonReader& body : bodies) {
        const double inverse_mass = body.at("inverse_mass_per_kg").number(0, std::numeric_limits<double>::max());
        system.awake.push_back(static_cast<int>(system.awake.size()));
        system.inverse_mass.push_back({.linear = inverse_mass,
                                       .linear_root = std::sqrt(inverse_mass),
                                       .angular = read_matrix(body.at("inverse_inertia_per_kg_m2")),
                                       .angular_root = read_matrix(body.at("inverse_inertia_root"))});
        system.free_acceleration.push_back(read_six(body.at("free_acceleration")));
    }
    const std::vector<JsonReader> rows = json.at("rows").elements();
    const auto count = static_cast<Eigen::Index>(rows.size());
    const std::size_t columns = rows.empty() ? 1 : rows.front().at("b_m_per_s2").elements().size();
    if (columns != 1 && columns != 2) rows.front().at("b_m_per_s2").refuse("one or two numbers");
    const std::string one_a_column = "one number per column";
    system.b.resize(count, static_cast<Eigen::Index>(columns));
    guesses.resizeLike(system.b);
    for (Eigen::Index j = 0; j < count; ++j) {
        const JsonReader& row = rows[static_cast<std::size_t>(j)];
        made.push_back(read_row(row, bodies.size(), made));
        const std::vector<double> b = row.at("b_m_per_s2").numbers(columns, one_a_column);
        const std::vector<double> guess = row.at("guess_n").numbers(columns, one_a_column);
        for (std::size_t c = 0; c < columns; ++c) {
            system.b(j, static_cast<Eigen::Index>(c)) = b[c];
            guesses(j, static_cast<Eigen::Index>(c)) = guess[c];
        }
        made.back().guess = {guess.front(), guess.back()};
    }
    if (!made.empty() && made.back().bounds.disc == engine::Disc::first) {
        rows.back().refuse("a row with \"disc\": \"second\" after it");
    }
    return {name, std::move(made), std::move(system), std::move(guesses)};
}

}  // namespace pushfactor::tests::problems
