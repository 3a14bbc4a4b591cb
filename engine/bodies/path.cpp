#include "engine/bodies/path.h"

#include "engine/bodies/integrator.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace pushfactor::engine {

namespace {

constexpr double same_time = 1e-9;

bool is_same(double time, double other) {
    return std::abs(time - other) <= same_time * std::abs(time);
}

// Rotation vector of the shorter way from one orientation to another [rad], world frame.
Vector3 turn_between(const Quaternion& from, const Quaternion& to) {
    Quaternion turn = to * from.conjugate();
    if (turn.w() < 0.0) turn.coeffs() = -turn.coeffs();
    const double sine = turn.vec().norm();
    if (sine == 0.0) return Vector3::Zero();
    return 2.0 * elementary::atan2(sine, turn.w()) / sine * turn.vec();
}

}  // namespace

Motion Path::mean(double from, double until) const {
    const Place before = at(from), after = at(until);
    const double dt = until - from;
    return motion_between(before, after, dt);
}

Motion motion_between(const Place& before, const Place& after, double dt) {
    return {(after.position - before.position) / dt, turn_between(before.orientation, after.orientation) / dt};
}

double PathTimes::since_start(double time) const {
    if (time <= from || is_same(time, from)) return 0.0;
    return (is_same(time, until) ? until : std::min(time, until)) - from;
}

Place SteadyPath::at(double time) const {
    const double on_way = times_.since_start(time);
    if (on_way == 0.0) return start_;
    return {start_.position + on_way * motion_.velocity,
            (exponential(on_way * motion_.angular_velocity) * start_.orientation).normalized()};
}

// The turn is not limited to half a turn.
Motion SteadyPath::mean(double from, double until) const {
    const double on_way = times_.since_start(until) - times_.since_start(from);
    if (on_way == 0.0) return {};
    return {(at(until).position - at(from).position) / (until - from),
            on_way / (until - from) * motion_.angular_velocity};
}

Place Oscillation::at(double time) const {
    const double on_way = times_.since_start(time);
    if (on_way == 0.0) return start_;
    const double angle = 2.0 * std::numbers::pi * frequency_ * on_way + phase_;
    return {start_.position + (elementary::sin(angle) - elementary::sin(phase_)) * amplitude_, start_.orientation};
}

PlaceTable::PlaceTable(const Place& start, const std::vector<Entry>& entries) {
    Entry before{0.0, start};
    for (const Entry& entry : entries) {
        assert(entry.time > before.time);
        legs_.push_back({before.time, entry.time, before.place, entry.place,
                         turn_between(before.place.orientation, entry.place.orientation)});
        before = entry;
    }
    assert(!legs_.empty());
}

Place PlaceTable::at(double time) const {
    for (const Leg& leg : legs_) {
        if (is_same(time, leg.end)) return leg.to;
        if (time > leg.end) continue;
        const double share = std::max(0.0, time - leg.begin) / (leg.end - leg.begin);
        return {leg.from.position + share * (leg.to.position - leg.from.position),
                (exponential(share * leg.turn) * leg.from.orientation).normalized()};
    }
    return legs_.back().to;
}

Motion PlaceTable::mean(double from, double until) const {
    // Within one leg the turn is known even where rounding would hide it.
    for (const Leg& leg : legs_) {
        const bool begins = from >= leg.begin || is_same(from, leg.begin);
        const bool ends = until <= leg.end || is_same(until, leg.end);
        if (!begins || !ends) continue;
        return {(at(until).position - at(from).position) / (until - from), leg.turn / (leg.end - leg.begin)};
    }
    if (from >= legs_.back().end || is_same(from, legs_.back().end)) return {};
    return Path::mean(from, until);
}

}  // namespace pushfactor::engine
