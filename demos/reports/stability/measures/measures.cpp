#include "demos/reports/stability/measures/measures.h"

#include "demos/text/numbers.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
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

// States of each movable body, in the order of the scene, at all times of the trajectory.
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

double step_of(const States& states) {
    return states[1].time - states[0].time;
}

// Principal moments in the body frame [kg m^2].
Vector3 inertia_of(const BodyDescription& body) {
    const auto* sphere = std::get_if<SphereShape>(&body.shape);
    if (sphere) return Vector3::Constant(0.4 * *body.mass * sphere->radius * sphere->radius);
    const Vector3 squares = std::get<BoxShape>(body.shape).size.cwiseAbs2();
    return *body.mass / 12.0 * (Vector3::Constant(squares.sum()) - squares);
}

Vector3 turning(const State& state) {
    return state.orientation.conjugate() * state.w;
}

// Energy [J] with the momenta moved half a step forward, to the time of the positions: free flight then conserves
// it exactly.
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

// Total angle of rotation [rad]; less than half a turn per step.
double turned_angle(const States& states) {
    Vector3 sum = Vector3::Zero();
    for (std::size_t i = 1; i < states.size(); ++i) {
        const Quaternion& before = states[i - 1].orientation;
        const Eigen::AngleAxisd turn(states[i].orientation * before.conjugate());
        sum += turn.angle() * turn.axis();
    }
    return sum.norm();
}

// Mean over the last second [m/s^2].
std::optional<double> acceleration(const States& states) {
    const auto second = static_cast<std::size_t>(std::lround(1.0 / step_of(states)));
    if (states.size() <= second) return std::nullopt;
    const State& before = states[states.size() - 1 - second];
    const State& last = states.back();
    return (last.v - before.v).norm() / (last.time - before.time);
}

// Period [s], averaged from the first to the last passage of the centre through x = 0 in the direction of +x. None
// with fewer than two passages.
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

// Spread of the apexes of the first five flights after a bounce, from the parabolas through the positions [m].
std::optional<double> apex_spread(const States& all, const SceneDescription& scene) {
    const double g = scene.gravity.norm();
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

std::optional<double> energy_change(const States& all, const SceneDescription& scene) {
    const BodyDescription& body = scene.bodies.back();
    const auto energy = [&](const State& state) {
        return centred_energy(state, body, scene.gravity, step_of(all));
    };
    const double start = energy(all.front());
    return largest_of(all, [&](const State& state) { return std::abs(energy(state) - start); }) / std::abs(start);
}

// Relative change of the spin about the body's x axis or of that about the other two together, whichever is larger.
std::optional<double> spin_change(const States& all, const SceneDescription&) {
    const auto along = [](const State& state) { return std::abs(turning(state).x()); };
    const auto across = [](const State& state) { return turning(state).tail<2>().norm(); };
    const State& start = all.front();
    return largest_of(all, [&](const State& state) {
        return std::max(std::abs(along(state) / along(start) - 1.0), std::abs(across(state) / across(start) - 1.0));
    });
}

std::optional<double> angular_momentum_change(const States& all, const SceneDescription& scene) {
    const Vector3 inertia = inertia_of(scene.bodies.back());
    const auto momentum = [&](const State& state) -> Vector3 {
        return state.orientation * inertia.cwiseProduct(turning(state));
    };
    const Vector3 start = momentum(all.front());
    return largest_of(all, [&](const State& state) { return (momentum(state) - start).norm(); }) / start.norm();
}

using Values = std::vector<double>;
using Take = std::function<Values(const Evidence& evidence)>;

// One number per movable body; empty if one of them has none.
Take each(std::function<std::optional<double>(const States& states)> one) {
    return [one](const Evidence& evidence) {
        Values values;
        for (const States& states : tracks(evidence)) {
            const std::optional<double> value = one(states);
            if (!value) return Values{};
            values.push_back(*value);
        }
        return values;
    };
}

// One number per movable body: the largest `value` of its states, given the first one.
Take largest(double (*value)(const State& state, const State& start)) {
    return each([value](const States& states) {
        return largest_of(states, [&](const State& state) { return value(state, states.front()); });
    });
}

// A number of the last movable body of the scene.
Take last(std::optional<double> (*one)(const States& states, const SceneDescription& scene)) {
    return [one](const Evidence& evidence) {
        const std::optional<double> value = one(tracks(evidence).back(), *evidence.scene);
        return value ? Values{*value} : Values{};
    };
}

// Twins are bodies of the first and, in the same order, the second half of a scene's movable bodies. One number per
// pair: the largest difference of `value`.
Take twins(Vector3 (*value)(const State& state, const State& start)) {
    return [value](const Evidence& evidence) {
        const std::vector<States> all = tracks(evidence);
        Values found(all.size() / 2);
        for (std::size_t i = 0; i < found.size(); ++i) {
            const States &one = all[i], &other = all[found.size() + i];
            for (std::size_t k = 0; k < one.size(); ++k) {
                found[i] = std::max(found[i], (value(one[k], one[0]) - value(other[k], other[0])).norm());
            }
        }
        return found;
    };
}

struct Measure {
    std::string_view name, output;
    Take take;
};

const std::vector<Measure> measures{
    {"slide_m", "trajectory",
     each([](const States& states) { return level_distance(states.front(), states.back()); })},
    {"farthest_m", "trajectory", largest(level_distance)},
    // Distance from the vertical plane through the start along the first velocity.
    {"sideways_m", "trajectory", largest([](const State& state, const State& start) {
         return std::abs(start.v.cross(Vector3::UnitY()).normalized().dot(state.x - start.x));
     })},
    {"deflection_m_per_s", "trajectory",
     largest([](const State& state, const State& start) { return (state.v - start.v).norm(); })},
    {"acceleration_m_per_s2", "trajectory", each(acceleration)},
    {"last_speed_m_per_s", "trajectory", each([](const States& states) { return states.back().v.norm(); })},
    {"spin_rad_per_s", "trajectory", largest([](const State& state, const State&) { return state.w.norm(); })},
    {"vertical_spin_rad_per_s", "trajectory",
     largest([](const State& state, const State&) { return std::abs(state.w.y()); })},
    {"turned_rad", "trajectory", each(turned_angle)},
    {"swing_period_s", "trajectory", each(swing_period)},
    {"twin_distance_m", "trajectory",
     twins([](const State& state, const State& start) -> Vector3 { return state.x - start.x; })},
    {"twin_velocity_m_per_s", "trajectory", twins([](const State& state, const State&) { return state.v; })},
    // Depth of the centre below height 0.
    {"depth_m", "trajectory", last([](const States& states, const SceneDescription&) {
         return std::optional(largest_of(states, [](const State& state) { return -state.x.y(); }));
     })},
    {"spread_of_5_apexes_m", "trajectory", last(apex_spread)},
    {"relative_energy_change", "trajectory", last(energy_change)},
    {"relative_spin_change", "trajectory", last(spin_change)},
    {"relative_angular_momentum_change", "trajectory", last(angular_momentum_change)},
    {"penetration_at_end_m", "csv",
     [](const Evidence& run) { return Values{run.outputs.at("csv").at("max_penetration_m").back()}; }},
    {"largest_force_n", "rows",
     [](const Evidence& run) {
         double most = 0.0;
         for (const double force : run.outputs.at("rows").at("lambda_last_n"))
             most = std::max(most, std::abs(force));
         return Values{most};
     }},
    {"energy_change_at_end_j", "",
     [](const Evidence& run) {
         const auto number = [&](const char* name) { return run.summary.at(name).get<double>(); };
         return Values{std::abs(number("energy_final_j") - number("energy_initial_j"))};
     }},
};

const Measure* find(const std::string& name) {
    const auto found = std::find_if(measures.begin(), measures.end(),
                                    [&](const Measure& measure) { return measure.name == name; });
    return found == measures.end() ? nullptr : &*found;
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
