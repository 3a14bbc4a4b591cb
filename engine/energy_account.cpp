#include "engine/energy_account.h"

#include "engine/bodies/diagnostics.h"
#include "engine/impacts/impacts.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace pushfactor::engine {

namespace {

// Calls `visit(bodies, depth, force)` for each contact row: m, N.
template <typename Visit>
void each_contact(const World& world, const Visit& visit) {
    const std::span<const ConstraintRow> rows = world.rows();
    const Columns& lambda = world.lambda();
    for (std::size_t j = 0; j < rows.size(); ++j) {
        if (rows[j].label.kind != RowKind::contact) continue;
        visit(std::pair{rows[j].body_a, rows[j].body_b}, -rows[j].label.gap,
              lambda(static_cast<Eigen::Index>(j), lambda.cols() - 1));
    }
}

// Whether the pair is left out of the step because it rests, and so is as deep as before.
bool rests(const World& world, const std::pair<int, int>& bodies) {
    return world.rest && (world.rest->is_at_rest(bodies.first) || world.rest->is_at_rest(bodies.second));
}

// With the momenta of `after` in the place of `before`: its turn within the step changes the velocities, but no
// force of the step works on that.
Body pushed(const Body& before, const Body& after) {
    Body own = after;
    own.orientation = before.orientation;
    return own;
}

// Rate of a row along its axis [m/s], in the middle of the push.
double rate_of(const ConstraintRow& row, std::span<const Body> before, std::span<const Body> after) {
    const auto velocity_of = [&](int body) -> Vector6 {
        const Body& own = before[static_cast<std::size_t>(body)];
        const Body end = pushed(own, after[static_cast<std::size_t>(body)]);
        return 0.5 * stacked(velocity(own) + velocity(end), angular_velocity(own) + angular_velocity(end));
    };
    return row.jacobian.a.dot(velocity_of(row.body_a)) + row.jacobian.b.dot(velocity_of(row.body_b));
}

// Work of running belts on the bodies in contact with them, and of running motors [J]. A belt has its speed, a
// motor may be stalled or carried along.
double work_of_drives(const World& world, std::span<const Body> before) {
    const Columns& lambda = world.lambda();
    double work = 0.0;
    for (const Island& island : world.islands().all()) {
        if (!island.has(RowDigest::drives)) continue;
        for (const RowRun& run : island.runs) {
            for (int j = run.begin; j < run.end; ++j) {
                const ConstraintRow& row = world.rows()[static_cast<std::size_t>(j)];
                const double force = lambda(j, lambda.cols() - 1);
                if (row.label.kind == RowKind::friction) work += force * row.push.lasting;
                if (row.label.kind == RowKind::motor && row.push.lasting != 0.0) {
                    const double rate = rate_of(row, before, world.bodies);
                    work += force * (rate - world.system().carried_by(static_cast<std::size_t>(j)));
                }
            }
        }
    }
    return work * world.system().dt;
}

}  // namespace

double EnergyAccount::energy(std::span<const Body> bodies, double dt) const {
    const double rising = -0.5 * dt * gravity_.dot(linear_momentum(bodies));
    return kinetic_energy(bodies) + potential_energy(bodies, gravity_) - std::max(0.0, rising);
}

void EnergyAccount::open(std::span<const Body> bodies, double dt, double stored) {
    *this = EnergyAccount(gravity_);
    start_ = latest_ = energy(bodies, dt) + stored;
}

void EnergyAccount::begin(std::span<const Body> bodies) {
    before_.assign(bodies.begin(), bodies.end());
}

void EnergyAccount::end(const World& world, double dt) {
    if (!world.rows().empty()) {
        if (!noted_) note_overlaps(world);
        push_ += work_of_removing(world);
    }
    noted_ = true;
    gain_ = latest_ - start_ - external_ - push_;
    external_ += external_work_of(world, dt);
    latest_ = energy(world.bodies, dt) + world.stored_energy();
}

void EnergyAccount::note_overlaps(const World& world) {
    std::map<Bodies, double> depths;
    each_contact(world, [&](const Bodies& bodies, double depth, double) {
        if (depth <= 0.0) return;
        double& deepest = depths[bodies];
        deepest = std::max(deepest, depth);
    });
    for (const auto& [bodies, depth] : depths) overlaps_.push_back({.bodies = bodies, .depth = depth});
}

// Until the beginning of the last step, with the forces of the step before it.
double EnergyAccount::work_of_removing(const World& world) {
    if (overlaps_.empty()) return 0.0;
    each_contact(world, [&](const Bodies& bodies, double depth, double force) {
        const auto found = std::ranges::lower_bound(overlaps_, bodies, {}, &Overlap::bodies);
        if (found == overlaps_.end() || found->bodies != bodies) return;
        found->is_seen = true;
        found->seen_depth = std::max(found->seen_depth, depth);
        found->seen_force += force;
    });
    double work = 0.0;
    for (Overlap& own : overlaps_) {
        if (!own.is_seen && rests(world, own.bodies)) continue;
        work += own.force * std::max(0.0, own.depth - own.seen_depth);
        own = {.bodies = own.bodies, .depth = std::min(own.depth, own.seen_depth), .force = own.seen_force};
    }
    std::erase_if(overlaps_, [](const Overlap& own) { return own.depth <= 0.0; });
    return work;
}

// Work of moved bodies on those that they touch or hold [J].
double EnergyAccount::work_of_moved(const World& world) const {
    const Columns& lambda = world.lambda();
    double work = 0.0;
    for (std::size_t j = 0; j < world.rows().size(); ++j) {
        const ConstraintRow& row = world.rows()[j];
        const auto along = [&](int moved, int other, const Vector6& axis) {
            const auto s = static_cast<std::size_t>(moved);
            const Motion &before = before_[s].prescribed, &now = world.bodies[s].prescribed;
            const Vector3 spin = 0.5 * (before.angular_velocity + now.angular_velocity);
            const Vector3 lever = before_[static_cast<std::size_t>(other)].position - before_[s].position;
            return axis.dot(stacked(0.5 * (before.velocity + now.velocity) + spin.cross(lever), spin));
        };
        const auto is_static = [&](int body) { return before_[static_cast<std::size_t>(body)].is_static(); };
        const double force = lambda(static_cast<Eigen::Index>(j), lambda.cols() - 1);
        if (is_static(row.body_a)) work += force * along(row.body_a, row.body_b, row.jacobian.b);
        if (is_static(row.body_b)) work += force * along(row.body_b, row.body_a, row.jacobian.a);
    }
    return work * world.system().dt;
}

// With the mean velocity of the step, which matches the momenta.
double EnergyAccount::external_work_of(const World& world, double dt) const {
    double work = world.rows().empty() ? 0.0 : work_of_drives(world, before_);
    if (world.impacts) work += world.impacts->external_work();
    if (world.moves_any()) work += work_of_moved(world);
    for (std::size_t i = 0; i < before_.size(); ++i) {
        const Body &before = before_[i], &after = world.bodies[i];
        if (before.is_static()) continue;
        const Vector3 force = after.force - gravity_ / after.inverse_mass;
        const Vector3 moved = 0.5 * dt * (velocity(before) + velocity(after));
        const Vector3 turned = 0.5 * dt * (angular_velocity(before) + angular_velocity(pushed(before, after)));
        work += force.dot(moved) + after.torque.dot(turned);
    }
    return work;
}

}  // namespace pushfactor::engine
