#include "demos/reports/stability/measures/measures.h"

#include "demos/reports/stability/measures/sliding.h"
#include "demos/text/numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

namespace pushfactor::demos::reports::stability {

namespace {

using engine::Vector3;

// Of the movable body that the scene names last.
std::vector<State> states(const Evidence& evidence) {
    return tracks(evidence).back().states;
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

using Values = std::vector<double>;

// A number of the whole run.
template <std::optional<double> (*one)(const Evidence&)>
Values of_run(const Evidence& evidence) {
    const std::optional<double> value = one(evidence);
    return value ? Values{*value} : Values{};
}

// A number of each movable body; nothing where one of them does not have it.
template <auto one>
Values of_each(const Evidence& evidence) {
    Values values;
    for (const Track& track : tracks(evidence)) {
        const std::optional<double> value = one(track);
        if (!value) return {};
        values.push_back(*value);
    }
    return values;
}

struct Measure {
    std::string_view name;
    std::string_view output;
    Values (*take)(const Evidence& evidence);
};

constexpr std::array measures{
    Measure{"depth_m", "trajectory", of_run<depth>},
    Measure{"deflection_m_per_s", "trajectory", of_each<deflection>},
    Measure{"acceleration_m_per_s2", "trajectory", of_each<acceleration>},
    Measure{"slide_m", "trajectory", of_each<slide>},
    Measure{"farthest_m", "trajectory", of_each<farthest>},
    Measure{"sideways_m", "trajectory", of_each<sideways>},
    Measure{"last_speed_m_per_s", "trajectory", of_each<last_speed>},
    Measure{"spin_rad_per_s", "trajectory", of_each<largest_spin>},
    Measure{"vertical_spin_rad_per_s", "trajectory", of_each<vertical_spin>},
    Measure{"turned_rad", "trajectory", of_each<turned_angle>},
    Measure{"swing_period_s", "trajectory", of_each<swing_period>},
    Measure{"twin_distance_m", "trajectory", twin_distances},
    Measure{"twin_velocity_m_per_s", "trajectory", twin_velocities},
    Measure{"spread_of_5_apexes_m", "trajectory", of_run<apex_spread>},
    Measure{"relative_energy_change", "trajectory", of_run<energy_change>},
    Measure{"relative_spin_change", "trajectory", of_run<spin_change>},
    Measure{"relative_angular_momentum_change", "trajectory", of_run<angular_momentum_change>},
    Measure{"penetration_at_end_m", "csv", of_run<penetration_at_end>},
    Measure{"largest_force_n", "rows", of_run<largest_force>},
    Measure{"energy_change_at_end_j", "", of_run<energy_change_at_end>},
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

std::vector<double> take(const std::string& measure, const Evidence& evidence) {
    if (const Measure* const found = find(measure)) return found->take(evidence);
    const Json& value = evidence.summary.at(measure);
    return value.is_number() ? Values{value.get<double>()} : Values{};
}

}  // namespace pushfactor::demos::reports::stability
