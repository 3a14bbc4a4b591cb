// The measures by which trials are judged, from the output of a run.
#include "demos/reports/stability/stability.h"

#include <cmath>

namespace pushfactor::demos::reports::stability {

namespace {

using engine::Quaternion;

struct State {
    double time = 0.0;  // s
    Vector3 x, v, w;    // m, m/s, rad/s
    Quaternion orientation;

    Vector3 turning() const { return orientation.conjugate() * w; }  // body frame
};

// A movable body at all times of the trajectory.
struct Track {
    const BodyDescription* body;
    Vector3 gravity;
    std::vector<State> states{};

    const State& start() const { return states.front(); }
    double step() const { return states[1].time - states[0].time; }

    template <typename Value>
    double largest(const Value& value) const {
        double largest = 0.0;
        for (const State& state : states) largest = std::max(largest, value(state));
        return largest;
    }
};

// In the order of the scene.
std::vector<Track> tracks_in(const Evidence& evidence) {
    std::vector<Track> found;
    for (const BodyDescription& body : evidence.scene->bodies) {
        if (body.mass) found.push_back({&body, evidence.scene->gravity});
    }
    const Columns& all = evidence.outputs.at("trajectory");
    for (std::size_t i = 0; i < all.at("time_s").size(); ++i) {
        const auto at = [&](const char* column) { return all.at(column)[i]; };
        found[i % found.size()].states.push_back(
            {.time = at("time_s"),
             .x = {at("x_m"), at("y_m"), at("z_m")},
             .v = {at("vx_m_per_s"), at("vy_m_per_s"), at("vz_m_per_s")},
             .w = {at("wx_rad_per_s"), at("wy_rad_per_s"), at("wz_rad_per_s")},
             .orientation = Quaternion(at("qw"), at("qx"), at("qy"), at("qz"))});
    }
    return found;
}

// Principal moments in the body frame [kg m^2].
Vector3 inertia_of(const BodyDescription& body) {
    const auto* sphere = std::get_if<SphereShape>(&body.shape);
    if (sphere) return Vector3::Constant(0.4 * *body.mass * sphere->radius * sphere->radius);
    const Vector3 squares = std::get<BoxShape>(body.shape).size.cwiseAbs2();
    return *body.mass / 12.0 * (Vector3::Constant(squares.sum()) - squares);
}

double level_distance(const State& state, const State& start) {
    return std::hypot(state.x.x() - start.x.x(), state.x.z() - start.x.z());
}

// Distance from the vertical plane through the start along the first velocity.
double sideways(const State& state, const State& start) {
    return std::abs(start.v.cross(Vector3::UnitY()).normalized().dot(state.x - start.x));
}

using Value = std::optional<double>;

// Total angle of rotation [rad]; less than half a turn per step.
Value turned_angle(const Track& track) {
    Vector3 sum = Vector3::Zero();
    for (std::size_t i = 1; i < track.states.size(); ++i) {
        const Quaternion& before = track.states[i - 1].orientation;
        const Eigen::AngleAxisd turn(track.states[i].orientation * before.conjugate());
        sum += turn.angle() * turn.axis();
    }
    return sum.norm();
}

// Mean over the last second [m/s^2].
Value acceleration(const Track& track) {
    const auto second = static_cast<std::size_t>(std::lround(1.0 / track.step()));
    if (track.states.size() <= second) return std::nullopt;
    const State& before = track.states[track.states.size() - 1 - second];
    const State& last = track.states.back();
    return (last.v - before.v).norm() / (last.time - before.time);
}

// Period [s], averaged from the first to the last passage of the centre through x = 0 in the direction of +x. None
// with fewer than two passages.
Value swing_period(const Track& track) {
    std::vector<double> passages;  // s
    for (std::size_t i = 1; i < track.states.size(); ++i) {
        const State &before = track.states[i - 1], &after = track.states[i];
        if (before.x.x() >= 0.0 || after.x.x() < 0.0) continue;
        const double share = -before.x.x() / (after.x.x() - before.x.x());
        passages.push_back(before.time + share * (after.time - before.time));
    }
    if (passages.size() < 2) return std::nullopt;
    return (passages.back() - passages.front()) / static_cast<double>(passages.size() - 1);
}

// Spread of the apexes of the first five flights after a bounce, from the parabolas through the positions [m].
Value apex_spread(const Track& track) {
    const double g = track.gravity.norm();
    std::vector<double> apexes;
    for (std::size_t i = 1; i < track.states.size() && apexes.size() < 5; ++i) {
        const State& before = track.states[i - 1];
        if (before.v.y() <= 0.0 || track.states[i].v.y() > 0.0) continue;
        const double speed = before.v.y() - 0.5 * g * track.step();
        apexes.push_back(before.x.y() + 0.5 * speed * speed / g);
    }
    if (apexes.size() < 5) return std::nullopt;
    const auto [low, high] = std::ranges::minmax(apexes);
    return high - low;
}

// With the momenta moved half a step forward, to the time of the positions: free flight then conserves energy
// exactly.
Value energy_change(const Track& track) {
    const Vector3 inertia = inertia_of(*track.body);
    const auto energy = [&](const State& state) {
        const Vector3 v = state.v + 0.5 * track.step() * track.gravity;
        const double moving = 0.5 * *track.body->mass * (v.squaredNorm() - 2.0 * track.gravity.dot(state.x));
        return moving + 0.5 * state.turning().dot(inertia.cwiseProduct(state.turning()));
    };
    const double start = energy(track.start());
    return track.largest([&](const State& state) { return std::abs(energy(state) - start); }) / std::abs(start);
}

// Relative change of the spin about the body's x axis or of that about the other two together, whichever is larger.
Value spin_change(const Track& track) {
    const auto along = [](const State& state) { return std::abs(state.turning().x()); };
    const auto across = [](const State& state) { return state.turning().tail<2>().norm(); };
    return track.largest([&](const State& state) {
        return std::max(std::abs(along(state) / along(track.start()) - 1.0),
                        std::abs(across(state) / across(track.start()) - 1.0));
    });
}

Value angular_momentum_change(const Track& track) {
    const Vector3 inertia = inertia_of(*track.body);
    const auto momentum = [&](const State& state) -> Vector3 {
        return state.orientation * inertia.cwiseProduct(state.turning());
    };
    const Vector3 start = momentum(track.start());
    return track.largest([&](const State& state) { return (momentum(state) - start).norm(); }) / start.norm();
}

using Values = std::vector<double>;
using Take = std::function<Values(const Evidence& evidence)>;

// One number per movable body; empty if one of them has none.
Take each(std::function<Value(const Track& track)> one) {
    return [one](const Evidence& evidence) {
        Values values;
        for (const Track& track : tracks_in(evidence)) {
            const Value value = one(track);
            if (!value) return Values{};
            values.push_back(*value);
        }
        return values;
    };
}

// One number per movable body: the largest `value` of its states, given the first one.
Take largest(double (*value)(const State& state, const State& start)) {
    return each([value](const Track& track) {
        return track.largest([&](const State& state) { return value(state, track.start()); });
    });
}

// Twins are bodies of the first and, in the same order, the second half of a scene's movable bodies. One number per
// pair: the largest difference of `value`.
Take twins(Vector3 (*value)(const State& state, const State& start)) {
    return [value](const Evidence& evidence) {
        const std::vector<Track> all = tracks_in(evidence);
        Values found(all.size() / 2);
        for (std::size_t i = 0; i < found.size(); ++i) {
            const Track &one = all[i], &other = all[found.size() + i];
            for (std::size_t k = 0; k < one.states.size(); ++k) {
                const Vector3 own = value(one.states[k], one.start());
                found[i] = std::max(found[i], (own - value(other.states[k], other.start())).norm());
            }
        }
        return found;
    };
}

Values energy_change_at_end(const Evidence& run) {
    const auto number = [&](const char* name) { return run.summary.at(name).get<double>(); };
    return {std::abs(number("energy_final_j") - number("energy_initial_j"))};
}

Values largest_force(const Evidence& run) {
    double most = 0.0;
    for (const double force : run.outputs.at("rows").at("lambda_last_n")) most = std::max(most, std::abs(force));
    return {most};
}

struct Measure {
    std::string_view name;
    Take take;
    std::string_view output = "trajectory";  // that it needs
};

const std::vector<Measure> measures{
    {"slide_m", each([](const Track& track) { return level_distance(track.states.back(), track.start()); })},
    {"farthest_m", largest(level_distance)},
    {"sideways_m", largest(sideways)},
    {"deflection_m_per_s",
     largest([](const State& state, const State& start) { return (state.v - start.v).norm(); })},
    {"acceleration_m_per_s2", each(acceleration)},
    {"last_speed_m_per_s", each([](const Track& track) { return track.states.back().v.norm(); })},
    {"spin_rad_per_s", largest([](const State& state, const State&) { return state.w.norm(); })},
    {"vertical_spin_rad_per_s", largest([](const State& state, const State&) { return std::abs(state.w.y()); })},
    {"turned_rad", each(turned_angle)},
    {"swing_period_s", each(swing_period)},
    {"twin_distance_m", twins([](const State& state, const State& start) -> Vector3 { return state.x - start.x; })},
    {"twin_velocity_m_per_s", twins([](const State& state, const State&) { return state.v; })},
    // Of the centre below height 0.
    {"depth_m", largest([](const State& state, const State&) { return -state.x.y(); })},
    {"spread_of_5_apexes_m", each(apex_spread)},
    {"relative_energy_change", each(energy_change)},
    {"relative_spin_change", each(spin_change)},
    {"relative_angular_momentum_change", each(angular_momentum_change)},
    {"penetration_at_end_m",
     [](const Evidence& run) { return Values{run.outputs.at("csv").at("max_penetration_m").back()}; }, "csv"},
    {"largest_force_n", largest_force, "rows"},
    {"energy_change_at_end_j", energy_change_at_end, ""},
};

const Measure* find(const std::string& name) {
    const auto found = std::ranges::find(measures, name, &Measure::name);
    return found == measures.end() ? nullptr : &*found;
}

}  // namespace

std::vector<double> take(const std::string& measure, const Evidence& evidence) {
    if (const Measure* const found = find(measure)) return found->take(evidence);
    const Json& value = evidence.summary.at(measure);
    return value.is_number() ? Values{value.get<double>()} : Values{};
}

std::string_view output_of(const std::string& measure) {
    const Measure* const found = find(measure);
    return found ? found->output : "";
}

}  // namespace pushfactor::demos::reports::stability
