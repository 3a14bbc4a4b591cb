#include "demos/pictures/live/microscope.h"

#include "demos/base/text/errors.h"
#include "demos/options/simulation_options.h"
#include "demos/runs/records.h"
#include "engine/base/index.h"
#include "engine/solvers/pgs.h"

#include <fmt/format.h>

namespace pushfactor::demos::pictures::live {

namespace {

using engine::ConstraintRow;
using engine::SystemEquation;
using engine::Vector6;

template <typename Vector>
Json list_of(const Vector& vector) {
    return std::vector<double>(vector.data(), vector.data() + vector.size());
}

void require_watchable(const Simulation& simulation) {
    const Settings& settings = simulation.settings();
    const auto refuse = [](const std::string& field, const std::string& value, const std::string& allowed) {
        throw UsageError("{} {}: must be {} to look at its rows", field, value, allowed);
    };
    if (simulation.sample().step == 0) refuse("step", "0", "at least 1");
    if (settings.solver != "pgs") refuse("--solver", settings.solver, "pgs");
    if (settings.scheme != Scheme::whole && settings.scheme != Scheme::automatic) {
        refuse("--scheme", scheme_name(settings), "whole");
    }
    if (settings.friction_model == FrictionModel::cone) refuse("--friction-model", "cone", "paper or coulomb");
    if (simulation.sample().substeps != 1) {
        refuse("--substeps", std::to_string(simulation.sample().substeps), "1");
    }
    const long rows = simulation.scene().world.system().row_count();
    if (rows == 0) refuse("step", std::to_string(simulation.sample().step), "one in which something touches");
    if (rows > most_rows) refuse("rows", std::to_string(rows), fmt::format("at most {}", most_rows));
}

// In the text of JSON infinite bounds are null.
Json row_as_json(const ConstraintRow& row) {
    return {{"kind", name_of(row.label.kind)},
            {"a", row.body_a},
            {"b", row.body_b},
            {"jacobian", {list_of(row.jacobian.a), list_of(row.jacobian.b)}},
            {"correcting", row.push.correcting},
            {"lasting", row.push.lasting},
            {"c_min", row.bounds.c_min},
            {"c_max", row.bounds.c_max},
            {"of_row", row.bounds.of_row}};
}

// J M^-1 J^T and the softness, as section 6 has it; the solvers never form it.
Json matrix_of(const SystemEquation& system) {
    Json matrix = Json::array();
    std::vector<Vector6> forces(system.inverse_mass.size(), Vector6::Zero());
    for (const ConstraintRow& row : system.rows) {
        const std::size_t a = engine::at(row.body_a), b = engine::at(row.body_b);
        forces[a] = row.jacobian.a;
        forces[b] = row.jacobian.b;
        std::vector<double> line;
        for (std::size_t j = 0; j < system.rows.size(); ++j) {
            line.push_back(engine::acceleration_along(system, j, forces));
        }
        line[matrix.size()] += row.softness;
        matrix.push_back(line);
        forces[a] = forces[b] = Vector6::Zero();
    }
    return matrix;
}

engine::Columns guess_of(const SystemEquation& system) {
    engine::Columns lambda(system.row_count(), system.column_count());
    for (Eigen::Index j = 0; j < lambda.rows(); ++j) {
        const engine::Lambda& guess = system.rows[static_cast<std::size_t>(j)].guess;
        lambda(j, 0) = guess.first;
        lambda(j, lambda.cols() - 1) = guess.last;
    }
    return lambda;
}

// Per column, at the start and after each sweep. A solve of k sweeps is the first k of a longer one.
Json sweeps_of(const SystemEquation& system, int sweeps) {
    std::vector<Json> columns(static_cast<std::size_t>(system.column_count()), Json::array());
    const auto solver = engine::solvers::make_pgs();
    for (int k = 0; k <= sweeps; ++k) {
        engine::Columns lambda = guess_of(system);
        if (k > 0) solver->solve(system, {.iterations = k, .tolerance_high = 0.0, .tolerance_low = 0.0}, lambda);
        for (Eigen::Index column = 0; column < lambda.cols(); ++column) {
            columns[static_cast<std::size_t>(column)].push_back(list_of(lambda.col(column)));
        }
    }
    return columns;
}

Json body_as_json(const engine::Body& body) {
    const engine::Quaternion& q = body.orientation;
    return {{"position", list_of(body.position)},
            {"orientation", {q.w(), q.x(), q.y(), q.z()}},
            {"velocity", list_of(velocity(body))},
            {"angular_velocity", list_of(angular_velocity(body))}};
}

Json bodies_of(const Simulation& simulation) {
    Json bodies = Json::array();
    const auto& after = simulation.scene().world.bodies;
    for (std::size_t i = 0; i < after.size(); ++i) {
        bodies.push_back({{"name", body_name(simulation.scene(), static_cast<int>(i))},
                          {"mass", after[i].is_static() ? Json() : Json(after[i].mass())},
                          {"before", body_as_json(simulation.checkpoint_before().bodies[i])},
                          {"after", body_as_json(after[i])}});
    }
    return bodies;
}

Json contacts_of(const BuiltScene& scene) {
    Json contacts = Json::array();
    if (!scene.contacts) return contacts;
    for (const engine::ContactSite& site : scene.contacts->sites()) {
        Json contact{{"row", site.normal_row}, {"place", list_of(site.position)}, {"normal", list_of(site.normal)}};
        if (site.friction_row) {
            contact["friction_row"] = *site.friction_row;
            contact["tangents"] = {list_of(site.tangents[0]), list_of(site.tangents[1])};
        }
        contacts.push_back(std::move(contact));
    }
    return contacts;
}

}  // namespace

Json microscope(const Simulation& simulation) {
    require_watchable(simulation);
    const SystemEquation& system = simulation.scene().world.system();
    Json rows = Json::array(), b = Json::array();
    for (const ConstraintRow& row : system.rows) rows.push_back(row_as_json(row));
    for (Eigen::Index column = 0; column < system.column_count(); ++column)
        b.push_back(list_of(system.b.col(column)));
    return {{"step", simulation.sample().step},
            {"dt", system.dt},
            {"rows", std::move(rows)},
            {"A", matrix_of(system)},
            {"diagonal", list_of(system.diagonal)},
            {"b", std::move(b)},
            {"lambda", sweeps_of(system, simulation.settings().iterations)},
            {"bodies", bodies_of(simulation)},
            {"contacts", contacts_of(simulation.scene())}};
}

}  // namespace pushfactor::demos::pictures::live
