#include "engine/step/rest.h"

#include "engine/base/constants.h"
#include "engine/base/index.h"

#include <algorithm>
#include <cmath>
#include <numeric>
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

// Whether the body is within the bound of the place.
bool is_near(const Body& body, const Sizes& sizes, const Rest::Memory& place) {
    const double limit = constants::rest::bound * sizes.small;
    return (body.position - place.position).squaredNorm() <= limit * limit;
}

// Whether it has turned by no more than that.
bool is_turned_alike(const Body& body, const Sizes& sizes, const Rest::Memory& place) {
    const double limit = constants::rest::bound * sizes.small;
    // |q - q'| of unit quaternions is half of a small angle between them.
    const double apart = std::min((body.orientation.coeffs() - place.orientation.coeffs()).squaredNorm(),
                                  (body.orientation.coeffs() + place.orientation.coeffs()).squaredNorm());
    return 4.0 * sizes.large * sizes.large * apart <= limit * limit;
}

// Whether its spin has changed so little that in the time the additional turn stays within the bound.
bool spins_alike(const Body& body, const Rest::Memory& place) {
    const double change = (body.angular_momentum - place.spin).norm() * body.inverse_inertia.maxCoeff();
    return change * constants::rest::time <= constants::rest::bound;
}

bool is_in_equilibrium(const Body& body, const Vector6& force_of_rows) {
    const double limit = constants::rest::share_of_weight * body.force.norm();
    return (body.force + force_of_rows.head<3>()).norm() <= limit &&
           (body.torque + force_of_rows.tail<3>()).norm() <= limit * Sizes(body).large;
}

bool has_force(const Columns& lambda, std::size_t row) {
    return (lambda.row(static_cast<Eigen::Index>(row)).array() != 0.0).any();
}

}  // namespace

bool Rest::is_still(int body) const {
    return at(body) < memory_.size() && memory_[at(body)].still >= constants::rest::time;
}

std::vector<int> Rest::take_changed() {
    return std::exchange(changed_, {});
}

void Rest::list_turning(std::span<const Body> bodies) {
    turning_.clear();
    for (std::size_t i = 0; i < memory_.size(); ++i) {
        if (memory_[i].group >= 0 && !bodies[i].angular_momentum.isZero(0.0))
            turning_.push_back(static_cast<int>(i));
    }
}

void Rest::join_group(int body, int leader) {
    memory_[at(body)].group = leader;
    if (body != leader) next_[at(body)] = std::exchange(next_[at(leader)], body);
    ++count_;
    changed_.push_back(body);
}

void Rest::wake(int body) {
    if (at(body) >= memory_.size()) return;
    memory_[at(body)].still = memory_[at(body)].here = 0.0;
    if (memory_[at(body)].group < 0) return;
    for (int next = body; memory_[at(next)].group >= 0; next = std::exchange(next_[at(next)], next)) {
        memory_[at(next)].group = -1;
        memory_[at(next)].still = memory_[at(next)].here = 0.0;
        changed_.push_back(next);
        --count_;
    }
    std::erase_if(turning_, [this](int other) { return !is_at_rest(other); });
}

void Rest::wake_all() {
    for (std::size_t body = 0; body < memory_.size(); ++body) wake(static_cast<int>(body));
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
                    const StepSolver& solved, double dt) {
    if (memory_.empty()) set_memory(std::vector<Memory>(bodies.size()), bodies);
    note_places(bodies, turns_unseen, system.awake, dt);
    const int before = count_;
    for (const Island& island : solved.islands().all()) {
        const bool any_still =
            std::any_of(island.bodies.begin(), island.bodies.end(), [this](int body) { return is_still(body); });
        if (!any_still) continue;
        find_groups(bodies, system, solved, island);
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
        Memory& memory = memory_[at(index)];
        const bool spins_on = turns_unseen[at(index)] && spins_alike(body, memory);
        if ((spins_on || is_turned_alike(body, sizes, memory)) && is_near(body, sizes, memory)) {
            memory.still += dt;
            memory.here += dt;
            if (!spins_on) memory.spin.setZero();
        } else {
            if (memory.here < constants::rest::time) memory.still = 0.0;
            memory.here = 0.0;
            memory.position = body.position;
            memory.orientation = body.orientation;
            memory.spin = turns_unseen[at(index)] ? body.angular_momentum : Vector3::Zero();
        }
    }
}

int Rest::root_of(int number) {
    while (groups_[at(number)].parent != number) {
        number = groups_[at(number)].parent = groups_[at(groups_[at(number)].parent)].parent;
    }
    return number;
}

void Rest::find_groups(std::span<const Body> bodies, const SystemEquation& system, const StepSolver& solved,
                       const Island& island) {
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
        const int body = island.bodies[at(k)];
        groups_[at(k)].may_rest =
            is_still(body) && is_in_equilibrium(bodies[at(body)], solved.lasting_force(at(body)));
    }
    for (const RowRun& run : island.runs) {
        // A running belt or motor or a moved body does not move what is held on it now, but may take it along
        // later, or go away.
        const auto rows = std::span(system.digests).subspan(at(run.begin), at(run.end - run.begin));
        const bool runs_along =
            bodies[at(rows.front().body_a)].is_moved() || bodies[at(rows.front().body_b)].is_moved() ||
            std::any_of(rows.begin(), rows.end(), [](const RowDigest& row) { return row.has(RowDigest::drives); });
        bool any_force = false;
        for (int j = run.begin; j < run.end && !any_force; ++j) any_force = has_force(solved.lambda(), at(j));
        for (const auto& [number, other] : {std::pair{run.a, run.b}, std::pair{run.b, run.a}}) {
            if (number >= island.movable()) continue;
            Group& group = groups_[at(root_of(number))];
            if (runs_along) group.may_rest = false;
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
        const Memory& memory = memory_[at(index)];
        if (memory.spin.isZero(0.0) || is_turned_alike(body, Sizes(body), memory)) body.angular_momentum.setZero();
        join_group(index, island.bodies[at(root)]);
    }
}

void Rest::set_memory(std::span<const Memory> memory, std::span<const Body> bodies) {
    memory_.assign(memory.begin(), memory.end());
    memory_.resize(bodies.size());
    next_.resize(bodies.size());
    std::iota(next_.begin(), next_.end(), 0);
    count_ = 0;
    for (int body = 0; at(body) < memory_.size(); ++body) {
        if (memory_[at(body)].group >= 0) join_group(body, memory_[at(body)].group);
    }
    list_turning(bodies);
    changed_.resize(bodies.size());
    std::iota(changed_.begin(), changed_.end(), 0);
}

}  // namespace pushfactor::engine
