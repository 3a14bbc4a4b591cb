#include "engine/impacts/impacts.h"

#include "engine/base/constants.h"
#include "engine/base/index.h"
#include "engine/collision/meeting.h"
#include "engine/constraints/carried.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pushfactor::engine {

namespace {

// Time between impacts that count as one, as a share of the step: more than what finding them leaves.
constexpr double at_once = 1e-6;

bool is_closed(const ConstraintRow& row) {
    return row.bounds.c_min >= 0.0 ? row.error <= 0.0 : row.bounds.c_max <= 0.0 ? row.error >= 0.0 : true;
}

// Whether a row that is no contact keeps its velocity however hard it is hit: not springs and motors of limited
// torque.
bool holds(const ConstraintRow& row) {
    if (row.label.kind == RowKind::contact || row.label.kind == RowKind::friction) return false;
    const bool is_rigid = row.softness == 0.0 || row.label.kind == RowKind::joint;
    const bool is_bounded = row.bounds.c_min > -infinity && row.bounds.c_max < infinity;
    return is_rigid && !is_bounded && is_closed(row);
}

Vector6 acceleration_by(const Body& body, const Vector6& force) {
    return stacked(body.inverse_mass * force.head<3>(), world_inverse_inertia(body) * force.tail<3>());
}

}  // namespace

bool Impacts::fly(const StepStart& step, const RowSources& sources, std::span<const ConstraintRow> rows,
                  const Awake& awake) {
    followed_.clear();
    resting_.clear();
    count_ = 0;
    external_work_ = 0.0;
    is_cut_short_ = false;
    step_ = step;
    sources_ = sources;
    awake_ = &awake;
    if (turning_.empty()) measure_colliders();
    find_about_to_rebound();
    if (changed_.empty()) return false;
    begin(rows);
    set_off(0.0);
    while (!next_.empty()) {
        if (count_ >= constants::impacts::most_per_body * static_cast<int>(flights_.size())) {
            is_cut_short_ = true;
            break;
        }
        strike(rows);
        if (!resting_.empty()) return true;
    }
    for (const int body : flying_) {
        if (reach_[at(body)] >= 0.0 || flight_of(body).is_hit()) followed_.push_back(body);
    }
    std::sort(followed_.begin(), followed_.end());
    return true;
}

void Impacts::measure_colliders() {
    for (const collision::Collider& own : contacts_.colliders()) {
        turning_.push_back(std::sqrt(collision::squared_turning_radius(own.shape)));
        const Vector3 extents = collision::half_extents(own.shape, Matrix3::Identity());
        radii_.push_back(std::max(turning_.back(), extents.maxCoeff()));
    }
}

// Bodies of pairs that meet by their free motions, fast enough to rebound.
void Impacts::find_about_to_rebound() {
    changed_.clear();
    for (const collision::Touch& touch : contacts_.touches()) {
        if (touch.restitution == 0.0) continue;
        const Body &a = step_.bodies[at(touch.body_a)], &b = step_.bodies[at(touch.body_b)];
        const ImpactLimits limits = limits_of(touch);
        const double least = limits.least_speed(touch.normal, a.inverse_mass * a.force, b.inverse_mass * b.force);
        const Motion of_a = motion_of(a, step_.dt), of_b = motion_of(b, step_.dt);
        const double still = rounding_of_speeds * (of_a.velocity.norm() + of_b.velocity.norm());
        double speed = 0.0;
        if (touch.time > 0.0) {  // at whatever point
            speed = (of_a.velocity - of_b.velocity).norm() +
                    turning_[at(touch.pair.a)] * of_a.angular_velocity.norm() +
                    turning_[at(touch.pair.b)] * of_b.angular_velocity.norm();
        }
        for (const collision::ContactPoint& point : touch.points) {
            const double own =
                collision::closing_speed(of_a, a.position, of_b, b.position, point.position, touch.normal);
            if (point.gap <= constants::collision::meeting_gap * touch.size + own * step_.dt)
                speed = std::max(speed, own);
        }
        const bool rebounds = touch.restitution * speed > least && speed > still;
        if (!rebounds) continue;
        if (!a.is_static()) changed_.push_back(touch.body_a);
        if (!b.is_static()) changed_.push_back(touch.body_b);
    }
}

ImpactLimits Impacts::limits_of(const collision::Touch& touch) const {
    return {.size = touch.size, .touching = contacts_.touching_gap_of(touch.size), .dt = step_.dt};
}

void Impacts::begin(std::span<const ConstraintRow> rows) {
    const std::size_t count = step_.bodies.size();
    flights_.clear();
    flying_.clear();
    flight_of_.assign(count, -1);
    reach_.assign(count, -1.0);
    meetings_.clear();
    next_.clear();
    known_.clear();
    number_.assign(count, -1);
    find_what_holds(rows);
}

// Rows that take part in the impacts of their bodies, which bodies they connect, and how they accelerate them.
void Impacts::find_what_holds(std::span<const ConstraintRow> rows) {
    by_rows_.assign(step_.bodies.size(), Vector6::Zero());
    lies_.assign(step_.bodies.size(), 0);
    parent_.resize(step_.bodies.size());
    std::iota(parent_.begin(), parent_.end(), 0);
    holding_.clear();
    for (std::size_t j = 0; j < rows.size(); ++j) {
        const ConstraintRow& row = rows[j];
        if (row.label.kind == RowKind::contact || row.label.kind == RowKind::friction) continue;
        by_rows_[at(row.body_a)] += row.guess.last * row.jacobian.a;
        by_rows_[at(row.body_b)] += row.guess.last * row.jacobian.b;
        if (holds(row)) holding_.push_back(static_cast<int>(j));
    }
    contacts_.each_contact(
        [&](const collision::Touch& touch, const collision::ContactPoint& point, int normal, int friction) {
            const ConstraintRow& row = rows[at(normal)];
            if (point.gap > contacts_.touching_gap_of(touch.size)) return;
            if (row.guess.last > 0.0) lies_[at(row.body_a)] = lies_[at(row.body_b)] = 1;
            if (touch.restitution > 0.0) return;
            holding_.push_back(normal);
            if (friction >= 0) holding_.insert(holding_.end(), {friction, friction + 1});
        });
    std::sort(holding_.begin(), holding_.end());
    for (const int j : holding_) {
        const ConstraintRow& row = rows[at(j)];
        const bool both = !step_.bodies[at(row.body_a)].is_static() && !step_.bodies[at(row.body_b)].is_static();
        if (both) parent_[at(group_of(row.body_a))] = group_of(row.body_b);
    }
    leave_out_blows(rows);
}

// J v1 of a row of the step, and what external forces and `others`, by body or none, add in `time` [s]; m/s.
double Impacts::speed_along(const ConstraintRow& row, double time, std::span<const Vector6> others) const {
    double speed = -carried_speed(row, step_.bodies[at(row.body_a)], step_.bodies[at(row.body_b)], step_.dt);
    for (const auto& [body, axis] :
         {std::pair{row.body_a, row.jacobian.a}, std::pair{row.body_b, row.jacobian.b}}) {
        const Body& own = step_.bodies[at(body)];
        if (own.is_static()) continue;
        Vector6 force = stacked(own.force, own.torque);
        if (!others.empty()) force += others[at(body)];
        speed += axis.dot(stacked(velocity(own), angular_velocity(own)) + time * acceleration_by(own, force));
    }
    return speed;
}

// Forces of the last step may be those of an impact or of a stop. They count for a group only if they are better
// than none: lambda^T (A lambda / 2 - b) < 0, where b keeps the velocities of what connects the group.
void Impacts::leave_out_blows(std::span<const ConstraintRow> rows) {
    std::vector<double> worse(step_.bodies.size(), 0.0);  // by group, W
    for (const int j : holding_) {
        const ConstraintRow& row = rows[at(j)];
        if (row.label.kind == RowKind::contact || row.label.kind == RowKind::friction) continue;
        const double without = speed_along(row, step_.dt, {}), with = speed_along(row, step_.dt, by_rows_);
        const int movable = step_.bodies[at(row.body_a)].is_static() ? row.body_b : row.body_a;
        worse[at(group_of(movable))] += row.guess.last * (0.5 * (with + without) - speed_along(row, 0.0, {}));
    }
    for (std::size_t body = 0; body < by_rows_.size(); ++body) {
        if (worse[at(group_of(static_cast<int>(body)))] > 0.0) by_rows_[body].setZero();
    }
}

int Impacts::group_of(int body) {
    while (parent_[at(body)] != body) body = parent_[at(body)] = parent_[at(parent_[at(body)])];
    return body;
}

Flight& Impacts::fly_body(int body) {
    int& number = flight_of_[at(body)];
    if (number < 0) {
        const Body& own = step_.bodies[at(body)];
        const Vector6 weight = stacked(own.force, own.torque);
        Vector6 by_rows = Vector6::Zero();
        if (!own.is_static())
            by_rows = acceleration_by(own, lies_[at(body)] ? Vector6(-weight) : by_rows_[at(body)]);
        number = static_cast<int>(flights_.size());
        flights_.emplace_back(own, by_rows, step_.dt, step_.rotate);
        flying_.push_back(body);
        if (meetings_of_.size() < flights_.size()) meetings_of_.emplace_back();
        meetings_of_[flights_.size() - 1].clear();
    }
    return flights_[at(number)];
}

// Lets the changed bodies fly on from `time`: what they meet is foreseen anew.
void Impacts::set_off(double time) {
    std::vector<char> looking;  // by collider
    for (const int body : changed_) {
        const Flight& flight = fly_body(body);
        const Body now = flight.at(time);
        const double rest = step_.dt - time;
        const double way = (now.position - step_.bodies[at(body)].position).norm() +
                           rest * (velocity(now).norm() + rest * flight.fall().norm());
        if (way <= reach_[at(body)]) continue;
        reach_[at(body)] = 2.0 * way;
        for (const int collider : contacts_.colliders_of(body)) {
            const Vector3 reach = Vector3::Constant(1.01 * radii_[at(collider)] + reach_[at(body)]);
            contacts_.broad_phase().put(collider, {step_.bodies[at(body)].position, reach});
            looking.resize(contacts_.colliders().size());
            looking[at(collider)] = 1;
        }
    }
    for (const int body : changed_) {
        for (const int meeting : meetings_of_[at(flight_of_[at(body)])]) foresee(meeting, time);
    }
    if (looking.empty()) return;
    for (const collision::Pair& pair : contacts_.broad_phase().find_pairs_of(looking)) {
        if (!known_.insert(pair).second) continue;
        const collision::Touch touch = contacts_.touch_of(pair, step_.bodies);
        const auto number = static_cast<int>(meetings_.size());
        meetings_.push_back({.touch = touch, .limits = limits_of(touch), .time = never});
        for (const int body : {touch.body_a, touch.body_b}) {
            fly_body(body);
            meetings_of_[at(flight_of_[at(body)])].push_back(number);
        }
        foresee(number, time);
    }
}

Flier Impacts::flier(int collider) {
    const collision::Collider& own = contacts_.colliders()[at(collider)];
    fly_body(own.body);
    return {own.shape, flight_of(own.body), radii_[at(collider)], turning_[at(collider)]};
}

void Impacts::foresee(int number, double from) {
    Meeting& meeting = meetings_[at(number)];
    const Flier a = flier(meeting.touch.pair.a), b = flier(meeting.touch.pair.b);
    expect(number, next_impact(a, b, meeting.limits, from, manifold_).time);
}

void Impacts::expect(int number, double time) {
    Meeting& meeting = meetings_[at(number)];
    next_.erase({meeting.time, meeting.touch.pair, number});
    meeting.time = time;
    if (time < never) next_.insert({time, meeting.touch.pair, number});
}

// The number of a body in the problem; -1 if it is static and not one of the pair.
int Impacts::add_to_problem(int body, double time) {
    int& number = number_[at(body)];
    if (number >= 0) return number;
    number = static_cast<int>(members_.size());
    members_.push_back(body);
    problem_.bodies.push_back(fly_body(body).at(time));
    return number;
}

// A row of the step where its bodies are at `time`, if its source can follow them.
const ConstraintRow& Impacts::row_at(int row, double time, std::span<const ConstraintRow> rows) {
    const ConstraintRow& own = rows[at(row)];
    const ConstraintSource* const source = sources_.follower_of(row);
    if (!source) return own;
    int begin = row;
    while (begin > 0 && sources_.follower_of(begin - 1) == source &&
           rows[at(begin - 1)].label.point == own.label.point) {
        --begin;
    }
    if (begin != item_begin_) {
        item_begin_ = begin;
        item_.clear();
        const Body a = fly_body(own.body_a).at(time), b = fly_body(own.body_b).at(time);
        source->append_rows_of(at(own.label.point), {own.body_a, own.body_b, a, b}, step_.dt, item_);
    }
    return item_[at(row - begin)];
}

// The meetings that are next, and those at the same time between bodies of their groups.
void Impacts::find_struck() {
    const double latest = std::get<double>(*next_.begin()) + at_once * step_.dt;
    struck_.clear();
    struck_groups_.clear();
    const auto groups_of = [&](const Meeting& meeting) {
        std::vector<int> groups;
        for (const int body : {meeting.touch.body_a, meeting.touch.body_b}) {
            if (!step_.bodies[at(body)].is_static()) groups.push_back(group_of(body));
        }
        return groups;
    };
    const auto is_struck = [&](int group) {
        return std::ranges::find(struck_groups_, group) != struck_groups_.end();
    };
    for (bool more = true; more;) {
        more = false;
        for (const auto& [time, pair, number] : next_) {
            if (time > latest) break;
            if (std::ranges::find(struck_, number) != struck_.end()) continue;
            const std::vector<int> groups = groups_of(meetings_[at(number)]);
            if (!struck_.empty() && std::ranges::none_of(groups, is_struck)) continue;
            more = true;
            struck_.push_back(number);
            struck_groups_.insert(struck_groups_.end(), groups.begin(), groups.end());
        }
    }
}

// Appends the rows of a pair that hits each other.
void Impacts::add_pair(int number, double time) {
    const Meeting& meeting = meetings_[at(number)];
    collision::Touch touch = meeting.touch;
    touch.normal = manifold_.normal;
    touch.points = manifold_.points();
    const int a = add_to_problem(touch.body_a, time), b = add_to_problem(touch.body_b, time);
    const Body body_a = problem_.bodies[at(a)], body_b = problem_.bodies[at(b)];
    contacts_.append_impact_rows(touch, {a, b, body_a, body_b}, step_, problem_.rows);
    const Vector3 fall_a = flight_of(touch.body_a).fall(), fall_b = flight_of(touch.body_b).fall();
    problem_.pairs.push_back({.rows_end = problem_.rows.size(),
                              .restitution = touch.restitution,
                              .least_rebound = meeting.limits.least_speed(touch.normal, fall_a, fall_b)});
}

// Appends the rows that hold bodies of the groups of the pairs.
void Impacts::add_what_holds(double time, std::span<const ConstraintRow> rows) {
    int normal = -1;  // of the last contact
    item_begin_ = -1;
    for (const int j : holding_) {
        const ConstraintRow& row = rows[at(j)];
        const int movable = step_.bodies[at(row.body_a)].is_static() ? row.body_b : row.body_a;
        if (std::ranges::find(struck_groups_, group_of(movable)) == struck_groups_.end()) continue;
        const bool is_own = std::ranges::any_of(struck_, [&](int number) {
            const collision::Touch& touch = meetings_[at(number)].touch;
            return (row.body_a == touch.body_a && row.body_b == touch.body_b) ||
                   (row.body_a == touch.body_b && row.body_b == touch.body_a);
        });
        const bool is_contact = row.label.kind == RowKind::contact, slides = row.label.kind == RowKind::friction;
        if (is_own && (is_contact || slides)) continue;  // of the start of the step
        if (is_contact) normal = static_cast<int>(problem_.rows.size());
        ConstraintRow& copy = problem_.rows.emplace_back();
        copy = row_at(j, time, rows);
        copy.body_a = add_to_problem(row.body_a, time);
        copy.body_b = add_to_problem(row.body_b, time);
        if (row.bounds.of_row >= 0) {
            copy.bounds.of_row = normal;
        } else {
            copy.bounds.c_min *= step_.dt;  // an impulse
            copy.bounds.c_max *= step_.dt;
        }
        if (!is_contact && !slides) copy.push.lasting = speed_along(row, 0.0, {});
        copy.push.correcting = 0.0;
        copy.correction = nullptr;
        copy.guess = {};
        problem_.carried.push_back(
            carried_speed(row, step_.bodies[at(row.body_a)], step_.bodies[at(row.body_b)], step_.dt));
    }
}

void Impacts::strike(std::span<const ConstraintRow> rows) {
    find_struck();
    for (const int body : members_) number_[at(body)] = -1;
    members_.clear();
    problem_.bodies.clear();
    problem_.rows.clear();
    problem_.pairs.clear();
    problem_.carried.clear();
    double time = never, size = infinity;
    for (const int number : struck_) {
        Meeting& meeting = meetings_[at(number)];
        const NextImpact met = next_impact(flier(meeting.touch.pair.a), flier(meeting.touch.pair.b), meeting.limits,
                                           meeting.time, manifold_);
        expect(number, never);
        if (met.time == never) continue;
        if (time == never) time = met.time;
        ++count_;
        add_pair(number, time);
        meeting.limits.least += constants::impacts::share_of_lost * (1.0 - meeting.touch.restitution) * met.speed;
        size = std::min(size, meeting.touch.size);
    }
    if (time == never) return;
    const std::size_t own_members = members_.size();
    carried_speeds(problem_.bodies, step_.dt, problem_.rows.all(), problem_.carried);
    add_what_holds(time, rows);
    for (const int body : members_) {
        if (!step_.bodies[at(body)].is_static() && !awake_->has(body)) resting_.push_back(body);
    }
    if (!resting_.empty()) return;

    const std::span<const Vector6> impulses = solver_.solve(problem_);
    external_work_ += solver_.external_work();
    // The same pairs would meet again at once, with no better answer: they are contacts for the rest of the step.
    if (!solver_.is_solved()) {
        for (const int number : struck_) meetings_[at(number)].limits.least = infinity;
    }
    changed_.clear();
    for (std::size_t k = 0; k < members_.size(); ++k) {
        const Body& body = problem_.bodies[k];
        if (body.is_static() || impulses[k].isZero(0.0)) continue;
        fly_body(members_[k]).hit(time, impulses[k]);
        const double way = (step_.dt - time) * acceleration_by(body, impulses[k]).head<3>().norm();
        if (k < own_members || way > constants::impacts::noticed * size) changed_.push_back(members_[k]);
    }
    set_off(time);
}

}  // namespace pushfactor::engine
