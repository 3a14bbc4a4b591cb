#include "demos/reports/stability/measures/measures.h"

#include "demos/text/numbers.h"

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

struct State {
    double time = 0.0;  // s
    Vector3 x, v, w;
    Quaternion orientation;
};
using States = std::vector<State>;

// Of each movable body, in the order of the scene, at every moment of the trajectory.
std::vector<States> tracks(const Evidence& evidence) {
    const auto& bodies = evidence.scene->bodies;
    const auto movable = std::count_if(bodies.begin(), bodies.end(), [](const auto& body) { return body.mass; });
    std::vector<States> found(static_cast<std::size_t>(movable));
    const Columns& all = evidence.outputs.at("trajectory");
    for (std::size_t i = 0; i < all.at("time_s").size(); ++i) {
        const auto at = [&](const char* column) { return all.at(column)[i]; };
        found[i % found.size()].push_back({.time = at("time_s"),
                                           .x = {at("x_m"), at("y_m"), at("z_m")},
                                           .v = {at("vx_m_per_s"), at("vy_m_per_s"), at("vz_m_per_s")},
                                           .w = {at("wx_rad_per_s"), at("wy_rad_per_s"), at("wz_rad_per_s")},
                                           .orientation = Quaternion(at("qw"), at("qx"), at("qy"), at("qz"))});
    }
    return found;
}

// Of the movable body that the scene names last.
States states(const Evidence& evidence) {
    return tracks(evidence).back();
}

double step_of(const States& states) {
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
double largest_of(const States& states, const Value& value) {
    double largest = 0.0;
    for (const State& state : states) largest = std::max(largest, value(state));
    return largest;
}

double level_distance(const State& from, const State& to) {
    return std::hypot(to.x.x() - from.x.x(), to.x.z() - from.x.z());
}

// Half the movable bodies with their twins; `difference` compares a state with that of the twin.
template <typename Difference>
std::vector<double> over_twins(const Evidence& evidence, const Difference& difference) {
    const std::vector<States> all = tracks(evidence);
    const std::size_t half = all.size() / 2;
    std::vector<double> found;
    for (std::size_t i = 0; i < half; ++i) {
        const States &one = all[i], &other = all[half + i];
        double largest = 0.0;
        for (std::size_t k = 0; k < one.size(); ++k) {
            largest = std::max(largest, difference(one[0], one[k], other[0], other[k]));
        }
        found.push_back(largest);
    }
    return found;
}

// Distance of its end from its start, and its largest distance from there; horizontally [m].
double slide(const States& states) {
    return level_distance(states.front(), states.back());
}

double farthest(const States& states) {
    return largest_of(states, [&](const State& state) { return level_distance(states.front(), state); });
}

// Largest distance from the vertical plane through its start along its first velocity [m].
double sideways(const States& states) {
    const State& start = states.front();
    const Vector3 across = start.v.cross(Vector3::UnitY()).normalized();
    return largest_of(states, [&](const State& state) { return std::abs(across.dot(state.x - start.x)); });
}

double last_speed(const States& states) {
    return states.back().v.norm();
}

double largest_spin(const States& states) {
    return largest_of(states, [](const State& state) { return state.w.norm(); });
}

double vertical_spin(const States& states) {
    return largest_of(states, [](const State& state) { return std::abs(state.w.y()); });
}

// Angle that it turned in all, from one moment to the next by less than half a turn [rad].
double turned_angle(const States& states) {
    Vector3 sum = Vector3::Zero();
    for (std::size_t i = 1; i < states.size(); ++i) {
        const Quaternion& before = states[i - 1].orientation;
        const Eigen::AngleAxisd turn(states[i].orientation * before.conjugate());
        sum += turn.angle() * turn.axis();
    }
    return sum.norm();
}

// Over the last second [m/s^2].
std::optional<double> acceleration(const States& states) {
    const auto second = static_cast<std::size_t>(std::lround(1.0 / step_of(states)));
    if (states.size() <= second) return std::nullopt;
    const State& before = states[states.size() - 1 - second];
    const State& last = states.back();
    return (last.v - before.v).norm() / (last.time - before.time);
}

// Largest difference of the velocity from the first one [m/s].
double deflection(const States& states) {
    return largest_of(states, [&](const State& state) { return (state.v - states.front().v).norm(); });
}

// Time of a swing to and fro, from the first to the last passage of its centre through x = 0 in the direction of +x
// [s]. Nothing below two passages.
std::optional<double> swing_period(const States& states) {
    std::vector<double> passages;  // s
    for (std::size_t i = 1; i < states.size(); ++i) {
        const State& before = states[i - 1];
        const State& after = states[i];
        if (before.x.x() >= 0.0 || after.x.x() < 0.0) continue;
        const double share = -before.x.x() / (after.x.x() - before.x.x());
        passages.push_back(before.time + share * (after.time - before.time));
    }
    if (passages.size() < 2) return std::nullopt;
    return (passages.back() - passages.front()) / static_cast<double>(passages.size() - 1);
}

// Twins: the first half of a scene's movable bodies and, in the same order, the second half. Largest differences of
// their ways [m] and velocities [m/s]: one number per pair.
std::vector<double> twin_distances(const Evidence& evidence) {
    return over_twins(evidence,
                      [](const State& start, const State& now, const State& twin_start, const State& twin) {
                          return ((now.x - start.x) - (twin.x - twin_start.x)).norm();
                      });
}

std::vector<double> twin_velocities(const Evidence& evidence) {
    return over_twins(evidence, [](const State&, const State& now, const State&, const State& twin) {
        return (now.v - twin.v).norm();
    });
}

// Of the run as a whole, or of the body that the scene names last.

// How far below height 0 its centre comes.
std::optional<double> depth(const Evidence& evidence) {
    return largest_of(states(evidence), [](const State& state) { return -state.x.y(); });
}

// Between the tops of the first five flights after a bounce, from the parabolas through the positions.
std::optional<double> apex_spread(const Evidence& evidence) {
    const States all = states(evidence);
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
    const States all = states(evidence);
    const BodyDescription& body = evidence.scene->bodies.back();
    const auto energy = [&](const State& state) {
        return centred_energy(state, body, evidence.scene->gravity, step_of(all));
    };
    const double start = energy(all.front());
    return largest_of(all, [&](const State& state) { return std::abs(energy(state) - start); }) / std::abs(start);
}

// About the body's x axis, and about those across it together, whichever changed more; of the start's.
std::optional<double> spin_change(const Evidence& evidence) {
    const States all = states(evidence);
    const auto along = [](const State& state) { return std::abs(turning(state).x()); };
    const auto across = [](const State& state) { return turning(state).tail<2>().norm(); };
    const State& start = all.front();
    return largest_of(all, [&](const State& state) {
        return std::max(std::abs(along(state) / along(start) - 1.0), std::abs(across(state) / across(start) - 1.0));
    });
}

std::optional<double> angular_momentum_change(const Evidence& evidence) {
    const States all = states(evidence);
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
    for (const States& states : tracks(evidence)) {
        const std::optional<double> value = one(states);
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
