#include "demos/reports/stability/measures/sliding.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::demos::reports::stability {

namespace {

using engine::Quaternion;
using engine::Vector3;

template <typename Value>
double largest_of(const Track& track, const Value& value) {
    double largest = 0.0;
    for (const State& state : track.states) largest = std::max(largest, value(state));
    return largest;
}

double level_distance(const State& from, const State& to) {
    return std::hypot(to.x.x() - from.x.x(), to.x.z() - from.x.z());
}

// Half the movable bodies with their twins; `difference` compares a state with that of the twin.
template <typename Difference>
std::vector<double> over_twins(const Evidence& evidence, const Difference& difference) {
    const std::vector<Track> all = tracks(evidence);
    const std::size_t half = all.size() / 2;
    std::vector<double> found;
    for (std::size_t i = 0; i < half; ++i) {
        const std::vector<State>& one = all[i].states;
        const std::vector<State>& other = all[half + i].states;
        double largest = 0.0;
        for (std::size_t k = 0; k < one.size(); ++k) {
            largest = std::max(largest, difference(one[0], one[k], other[0], other[k]));
        }
        found.push_back(largest);
    }
    return found;
}

}  // namespace

double slide(const Track& track) {
    return level_distance(track.states.front(), track.states.back());
}

double farthest(const Track& track) {
    return largest_of(track, [&](const State& state) { return level_distance(track.states.front(), state); });
}

double sideways(const Track& track) {
    const State& start = track.states.front();
    const Vector3 across = start.v.cross(Vector3::UnitY()).normalized();
    return largest_of(track, [&](const State& state) { return std::abs(across.dot(state.x - start.x)); });
}

double last_speed(const Track& track) {
    return track.states.back().v.norm();
}

double largest_spin(const Track& track) {
    return largest_of(track, [](const State& state) { return state.w.norm(); });
}

double vertical_spin(const Track& track) {
    return largest_of(track, [](const State& state) { return std::abs(state.w.y()); });
}

double turned_angle(const Track& track) {
    Vector3 sum = Vector3::Zero();
    for (std::size_t i = 1; i < track.states.size(); ++i) {
        const Quaternion& before = track.states[i - 1].orientation;
        const Eigen::AngleAxisd turn(track.states[i].orientation * before.conjugate());
        sum += turn.angle() * turn.axis();
    }
    return sum.norm();
}

std::optional<double> acceleration(const Track& track) {
    const auto second = static_cast<std::size_t>(std::lround(1.0 / track.step()));
    if (track.states.size() <= second) return std::nullopt;
    const State& before = track.states[track.states.size() - 1 - second];
    const State& last = track.states.back();
    return (last.v - before.v).norm() / (last.time - before.time);
}

double deflection(const Track& track) {
    return largest_of(track, [&](const State& state) { return (state.v - track.states.front().v).norm(); });
}

std::optional<double> swing_period(const Track& track) {
    std::vector<double> passages;  // s
    for (std::size_t i = 1; i < track.states.size(); ++i) {
        const State& before = track.states[i - 1];
        const State& after = track.states[i];
        if (before.x.x() >= 0.0 || after.x.x() < 0.0) continue;
        const double share = -before.x.x() / (after.x.x() - before.x.x());
        passages.push_back(before.time + share * (after.time - before.time));
    }
    if (passages.size() < 2) return std::nullopt;
    return (passages.back() - passages.front()) / static_cast<double>(passages.size() - 1);
}

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

}  // namespace pushfactor::demos::reports::stability
