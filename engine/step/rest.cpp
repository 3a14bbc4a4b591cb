#include "engine/step/rest.h"

#include "engine/base/index.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pushfactor::engine {

namespace {

// Edge lengths of the cubes whose moments of inertia are the smallest and the largest of the body [m]; m edge^2 /
// 6.
struct Sizes {
    explicit Sizes(const Body& body)
        : small(std::sqrt(6.0 * body.inverse_mass / body.inverse_inertia.maxCoeff())),
          large(std::sqrt(6.0 * body.inverse_mass / body.inverse_inertia.minCoeff())) {}
    double small, large;
};

// Whether the body is within `bound` of its size of the place.
bool is_near(const Body& body, const Sizes& sizes, double bound, const Rest::Stay& place) {
    const double limit = bound * sizes.small;
    return (body.position - place.position).squaredNorm() <= limit * limit;
}

// Whether it has turned by no more than that.
bool is_turned_alike(const Body& body, const Sizes& sizes, double bound, const Rest::Stay& place) {
    const double limit = bound * sizes.small;
    // |q - q'| of unit quaternions is half of a small angle between them.
    const double apart = std::min((body.orientation.coeffs() - place.orientation.coeffs()).squaredNorm(),
                                  (body.orientation.coeffs() + place.orientation.coeffs()).squaredNorm());
    return 4.0 * sizes.large * sizes.large * apart <= limit * limit;
}

// Whether its spin has changed so little that over the span the additional turn stays within the bound.
bool spins_alike(const Body& body, const Rest::Span& span, const Rest::Stay& place) {
    const double change = (body.angular_momentum - place.spin).norm() * body.inverse_inertia.maxCoeff();
    return change * span.time <= span.bound;
}

// Whether it has turned by at most this angle [rad].
bool is_turned_within(const Body& body, double angle, const Rest::Stay& place) {
    return std::abs(body.orientation.dot(place.orientation)) >= std::cos(0.5 * angle);
}

void forget_stays(Rest::Memory& memory) {
    for (Rest::Stay& stay : memory.stays) stay.still = 0.0;
}

bool has_force(const Columns& lambda, std::size_t row) {
    return (lambda.row(static_cast<Eigen::Index>(row)).array() != 0.0).any();
}

}  // namespace

bool Rest::is_still(int body) const {
    return std::any_of(spans.begin(), spans.end(), [&](const Span& span) { return is_still(body, span); });
}

bool Rest::is_still(int body, const Span& span) const {
    if (at(body) >= memory_.size()) return false;
    const auto number = static_cast<std::size_t>(&span - spans.data());
    return memory_[at(body)].stays[number].still >= span.time;
}

Awake Rest::awake(std::size_t bodies) const {
    std::vector<char> is_awake(bodies, 1);
    for (std::size_t i = 0; i < memory_.size(); ++i) is_awake[i] = memory_[i].group < 0;
    return Awake(std::move(is_awake));
}

bool Rest::take_change() {
    return std::exchange(changed_, false);
}

void Rest::list_turning(std::span<const Body> bodies) {
    turning_.clear();
    for (std::size_t i = 0; i < memory_.size(); ++i) {
        if (memory_[i].group >= 0 && !bodies[i].angular_momentum.isZero(0.0))
            turning_.push_back(static_cast<int>(i));
    }
}

void Rest::wake(int body) {
    if (at(body) >= memory_.size()) return;
    const int group = memory_[at(body)].group;
    forget_stays(memory_[at(body)]);
    if (group < 0) return;
    for (Memory& memory : memory_) {
        if (memory.group != group) continue;
        memory.group = -1;
        forget_stays(memory);
        --count_;
    }
    std::erase_if(turning_, [this](int other) { return !is_at_rest(other); });
    changed_ = true;
}

void Rest::wake_all() {
    for (Memory& memory : memory_) {
        memory.group = -1;
        forget_stays(memory);
    }
    count_ = 0;
    turning_.clear();
    changed_ = true;
}

bool Rest::wake_pushed(const SystemEquation& system, const Columns& lambda) {
    if (count_ == 0) return false;
    bool any = false;
    for (std::size_t j = 0; j < system.rows.size(); ++j) {
        if (!has_force(lambda, j)) continue;
        for (const int body : {system.rows[j].body_a, system.rows[j].body_b}) {
            if (!is_at_rest(body)) continue;
            wake(body);
            any = true;
        }
    }
    return any;
}

void Rest::end_step(std::span<Body> bodies, std::span<const char> turns_unseen, const SystemEquation& system,
                    const Islands& islands, const Columns& lambda, double dt) {
    memory_.resize(bodies.size());
    note_places(bodies, turns_unseen, system.awake, dt);
    const int before = count_;
    for (const Island& island : islands.all()) {
        const bool any_still =
            std::any_of(island.bodies.begin(), island.bodies.end(), [this](int body) { return is_still(body); });
        if (!any_still) continue;
        find_groups(bodies, system, island, lambda);
        bring_to_rest(bodies, island);
    }
    if (count_ != before) list_turning(bodies);
}

// Skips bodies that cannot turn, because they have no size to compare with.
void Rest::note_places(std::span<const Body> bodies, std::span<const char> turns_unseen, std::span<const int> awake,
                       double dt) {
    for (const int index : awake) {
        const Body& body = bodies[at(index)];
        if (!(body.inverse_inertia.minCoeff() > 0.0)) continue;
        const Sizes sizes(body);
        const bool unseen = turns_unseen[at(index)];
        for (std::size_t k = 0; k < spans.size(); ++k) {
            Stay& stay = memory_[at(index)].stays[k];
            const bool spins_on = unseen && spins_alike(body, spans[k], stay);
            const bool is_alike = spins_on || is_turned_alike(body, sizes, spans[k].bound, stay) ||
                                  (unseen && is_turned_within(body, spans[k].unseen_turn, stay));
            if (is_alike && is_near(body, sizes, spans[k].bound, stay)) {
                stay.still += dt;
                if (!spins_on) stay.spin.setZero();
            } else {
                stay = {.still = 0.0, .position = body.position, .orientation = body.orientation};
                if (unseen) stay.spin = body.angular_momentum;
            }
        }
    }
}

// Whether it was still in position only, with a constant spin of its own. A rocking body has none.
bool Rest::turns_on(const Body& body, const Memory& memory) const {
    for (std::size_t k = 0; k < spans.size(); ++k) {
        if (memory.stays[k].still < spans[k].time) continue;
        const bool spins_on = !memory.stays[k].spin.isZero(0.0);
        if (!spins_on || is_turned_alike(body, Sizes(body), spans[k].bound, memory.stays[k])) return false;
    }
    return true;
}

int Rest::root_of(int number) {
    while (groups_[at(number)].parent != number) {
        number = groups_[at(number)].parent = groups_[at(groups_[at(number)].parent)].parent;
    }
    return number;
}

void Rest::find_groups(std::span<const Body> bodies, const SystemEquation& system, const Island& island,
                       const Columns& lambda) {
    groups_.clear();
    for (int k = 0; k < island.movable(); ++k) groups_.push_back({.parent = k});
    const auto join = [this](int a, int b) {
        const auto [low, high] = std::minmax({root_of(a), root_of(b)});
        if (low == high) return;
        groups_[at(low)].is_held = groups_[at(low)].is_held || groups_[at(high)].is_held;
        groups_[at(low)].may_rest = groups_[at(low)].may_rest && groups_[at(high)].may_rest;
        groups_[at(high)].parent = low;
    };
    for (int k = 0; k < island.movable(); ++k) {
        if (!is_still(island.bodies[at(k)])) groups_[at(k)].may_rest = false;
    }
    for (const RowRun& run : island.runs) {
        // A running belt or motor or a moved body does not move what is held on it now, but may take it along
        // later, or go away.
        const auto rows = std::span(system.digests).subspan(at(run.begin), at(run.end - run.begin));
        const bool runs_along =
            bodies[at(rows.front().body_a)].is_moved() || bodies[at(rows.front().body_b)].is_moved() ||
            std::any_of(rows.begin(), rows.end(), [](const RowDigest& row) { return row.has(RowDigest::drives); });
        // What hangs may swing by little for ever.
        const bool hangs = std::any_of(rows.begin(), rows.end(), [](const RowDigest& row) {
            return row.kind != RowKind::contact && row.kind != RowKind::friction;
        });
        bool any_force = false;
        for (int j = run.begin; j < run.end && !any_force; ++j) any_force = has_force(lambda, at(j));
        for (const auto& [number, other] : {std::pair{run.a, run.b}, std::pair{run.b, run.a}}) {
            if (number >= island.movable()) continue;
            Group& group = groups_[at(root_of(number))];
            if (runs_along || (hangs && !is_still(island.bodies[at(number)], spans.front())))
                group.may_rest = false;
            if (!any_force) continue;
            if (other < island.movable()) {
                join(number, other);
            } else {
                group.is_held = true;
            }
        }
    }
}

// Only groups that are still and held.
void Rest::bring_to_rest(std::span<Body> bodies, const Island& island) {
    for (int k = 0; k < island.movable(); ++k) {
        const int root = root_of(k);
        const Group& group = groups_[at(root)];
        if (!group.may_rest || !group.is_held) continue;
        const int index = island.bodies[at(k)];
        Body& body = bodies[at(index)];
        body.linear_momentum.setZero();
        if (!turns_on(body, memory_[at(index)])) body.angular_momentum.setZero();
        memory_[at(index)].group = island.bodies[at(root)];
        ++count_;
        changed_ = true;
    }
}

void Rest::set_memory(std::span<const Memory> memory, std::span<const Body> bodies) {
    memory_.assign(memory.begin(), memory.end());
    count_ = static_cast<int>(
        std::count_if(memory_.begin(), memory_.end(), [](const Memory& own) { return own.group >= 0; }));
    list_turning(bodies);
    changed_ = true;
}

}  // namespace pushfactor::engine
