#include "demos/reports/stability/measures.h"

#include "demos/numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

namespace pushfactor::demos::reports::stability {

namespace {

using engine::Quaternion;
using engine::Vector3;

// The movable body that the scene names last, at one moment.
struct State {
    double time = 0.0;  // s
    Vector3 x, v, w;
    Quaternion orientation;
};

std::vector<State> states(const Evidence& evidence) {
    const Columns& all = evidence.outputs.at("trajectory");
    const auto movable = std::count_if(evidence.scene->bodies.begin(), evidence.scene->bodies.end(),
                                       [](const BodyDescription& body) { return body.mass.has_value(); });
    std::vector<State> found;
    const auto stride = static_cast<std::size_t>(movable);
    for (std::size_t i = stride - 1; i < all.at("time_s").size(); i += stride) {
        const auto at = [&](const char* column) { return all.at(column)[i]; };
        found.push_back({.time = at("time_s"),
                         .x = {at("x_m"), at("y_m"), at("z_m")},
                         .v = {at("vx_m_per_s"), at("vy_m_per_s"), at("vz_m_per_s")},
                         .w = {at("wx_rad_per_s"), at("wy_rad_per_s"), at("wz_rad_per_s")},
                         .orientation = Quaternion(at("qw"), at("qx"), at("qy"), at("qz"))});
    }
    return found;
}

double step_of(const std::vector<State>& states) {
    return states[1].time - states[0].time;
}

// kg m^2 in the body frame, of a box; of a ball all its edges are those with the same inertia.
Vector3 inertia_of(const BodyDescription& body) {
    const auto* sphere = std::get_if<SphereShape>(&body.shape);
    if (sphere) return Vector3::Constant(0.4 * *body.mass * sphere->radius * sphere->radius);
    const Vector3 squares = std::get<BoxShape>(body.shape).size.cwiseAbs2();
    return *body.mass / 12.0 * (Vector3::Constant(squares.sum()) - squares);
}

Vector3 turning(const State& state) {
    return state.orientation.conjugate() * state.w;
}

// The momenta belong half a step earlier than the positions; with both at one time free flight keeps it exactly.
double centred_energy(const State& state, const BodyDescription& body, const Vector3& gravity, double step) {
    const Vector3 v = state.v + 0.5 * step * gravity;
    const double moving = 0.5 * *body.mass * (v.squaredNorm() - 2.0 * gravity.dot(state.x));
    return moving + 0.5 * turning(state).dot(inertia_of(body).cwiseProduct(turning(state)));
}

template <typename Value>
double largest_of(const std::vector<State>& states, const Value& value) {
    double largest = 0.0;
    for (const State& state : states) largest = std::max(largest, value(state));
    return largest;
}

// How far below height 0 its centre comes.
std::optional<double> depth(const Evidence& evidence) {
    return largest_of(states(evidence), [](const State& state) { return -state.x.y(); });
}

std::optional<double> deflection(const Evidence& evidence) {
    const std::vector<State> all = states(evidence);
    return largest_of(all, [&](const State& state) { return (state.v - all.front().v).norm(); });
}

// Over the last second.
std::optional<double> acceleration(const Evidence& evidence) {
    const std::vector<State> all = states(evidence);
    const auto second = static_cast<std::size_t>(std::lround(1.0 / step_of(all)));
    if (all.size() <= second) return std::nullopt;
    const State& before = all[all.size() - 1 - second];
    return (all.back().v - before.v).norm() / (all.back().time - before.time);
}

// Between the tops of the first five flights after a bounce, from the parabolas through the positions.
std::optional<double> apex_spread(const Evidence& evidence) {
    const std::vector<State> all = states(evidence);
    const double g = evidence.scene->gravity.norm();
    std::vector<double> apexes;
    for (std::size_t i = 1; i < all.size() && apexes.size() < 5; ++i) {
        const double rising = all[i - 1].v.y();
        if (rising <= 0.0 || all[i].v.y() > 0.0) continue;
        const double speed = rising - 0.5 * g * step_of(all);
        apexes.push_back(all[i - 1].x.y() + 0.5 * speed * speed / g);
    }
    if (apexes.size() < 5) return std::nullopt;
    const auto [low, high] = std::minmax_element(apexes.begin(), apexes.end());
    return *high - *low;
}

std::optional<double> energy_change(const Evidence& evidence) {
    const std::vector<State> all = states(evidence);
    const BodyDescription& body = evidence.scene->bodies.back();
    const auto energy = [&](const State& state) {
        return centred_energy(state, body, evidence.scene->gravity, step_of(all));
    };
    const double start = energy(all.front());
    return largest_of(all, [&](const State& state) { return std::abs(energy(state) - start); }) / std::abs(start);
}

// About the body's x axis, and about those across it together, whichever changed more; of the start's.
std::optional<double> spin_change(const Evidence& evidence) {
    const std::vector<State> all = states(evidence);
    const auto along = [](const State& state) { return std::abs(turning(state).x()); };
    const auto across = [](const State& state) { return turning(state).tail<2>().norm(); };
    const State& start = all.front();
    return largest_of(all, [&](const State& state) {
        return std::max(std::abs(along(state) / along(start) - 1.0), std::abs(across(state) / across(start) - 1.0));
    });
}

std::optional<double> angular_momentum_change(const Evidence& evidence) {
    const std::vector<State> all = states(evidence);
    const Vector3 inertia = inertia_of(evidence.scene->bodies.back());
    const auto momentum = [&](const State& state) -> Vector3 {
        return state.orientation * inertia.cwiseProduct(turning(state));
    };
    const Vector3 start = momentum(all.front());
    return largest_of(all, [&](const State& state) { return (momentum(state) - start).norm(); }) / start.norm();
}

std::optional<double> penetration_at_end(const Evidence& evidence) {
    const Columns& steps = evidence.outputs.at("csv");
    return steps.at("max_penetration_m").back();
}

std::optional<double> largest_force(const Evidence& evidence) {
    double largest = 0.0;
    for (const double force : evidence.outputs.at("rows").at("lambda_last_n")) {
        largest = std::max(largest, std::abs(force));
    }
    return largest;
}

std::optional<double> energy_change_at_end(const Evidence& evidence) {
    const auto number = [&](const char* name) { return evidence.summary.at(name).get<double>(); };
    return std::abs(number("energy_final_j") - number("energy_initial_j"));
}

struct Measure {
    std::string_view name;
    std::string_view output;
    std::optional<double> (*take)(const Evidence& evidence);
};

constexpr std::array measures{
    Measure{"depth_m", "trajectory", depth},
    Measure{"deflection_m_per_s", "trajectory", deflection},
    Measure{"acceleration_m_per_s2", "trajectory", acceleration},
    Measure{"spread_of_5_apexes_m", "trajectory", apex_spread},
    Measure{"relative_energy_change", "trajectory", energy_change},
    Measure{"relative_spin_change", "trajectory", spin_change},
    Measure{"relative_angular_momentum_change", "trajectory", angular_momentum_change},
    Measure{"penetration_at_end_m", "csv", penetration_at_end},
    Measure{"largest_force_n", "rows", largest_force},
    Measure{"energy_change_at_end_j", "", energy_change_at_end},
};

const Measure* find(const std::string& name) {
    const auto* const found = std::find_if(measures.begin(), measures.end(),
                                           [&](const Measure& measure) { return measure.name == name; });
    return found == measures.end() ? nullptr : found;
}

}  // namespace

Columns read_columns(const std::filesystem::path& file) {
    std::ifstream stream(file);
    std::string line, field;
    std::getline(stream, line);
    std::vector<std::vector<double>*> columns;
    Columns result;
    for (std::istringstream names(line); std::getline(names, field, ',');) columns.push_back(&result[field]);
    while (std::getline(stream, line)) {
        std::istringstream fields(line);
        for (auto* const column : columns) {
            field.clear();
            std::getline(fields, field, ',');
            column->push_back(parse_number(field).value_or(std::numeric_limits<double>::quiet_NaN()));
        }
    }
    return result;
}

std::string output_for(const std::string& measure) {
    const Measure* const found = find(measure);
    return found ? std::string(found->output) : std::string();
}

std::optional<double> take(const std::string& measure, const Evidence& evidence) {
    if (const Measure* const found = find(measure)) return found->take(evidence);
    const Json& value = evidence.summary.at(measure);
    return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}

}  // namespace pushfactor::demos::reports::stability
