#include "tests/fuzz/step_claims.h"

#include "engine/bodies/diagnostics.h"
#include "engine/impacts/impacts.h"
#include "engine/step/choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pushfactor::tests {

namespace {

using engine::Body;
using engine::ConstraintRow;
using engine::SystemEquation;
using engine::Vector3;
using engine::Vector6;

// Rounding errors of sums of some hundred terms, as a share of the largest possible term.
constexpr double rounding = 1e-12;
// Smaller forces have squares of zero and lie within any disc.
constexpr double smallest = 1e-150;  // N

std::size_t at(Eigen::Index j) {
    return static_cast<std::size_t>(j);
}

// sum over rows of |lambda_j| times `weight` of the row, in the column that sets momenta.
template <typename Weight>
double sum_of_forces(const engine::World& world, Weight weight) {
    double sum = 0.0;
    const Eigen::Index last = world.lambda().cols() - 1;
    for (Eigen::Index j = 0; j < world.lambda().rows(); ++j) {
        sum += std::abs(world.lambda()(j, last)) * weight(world.rows()[at(j)]);
    }
    return sum;
}

std::optional<Broken> linear_momentum(const Step& step) {
    const Vector3 change = engine::linear_momentum(step.world.bodies) - engine::linear_momentum(step.before);
    double scale = step.world.system().dt * sum_of_forces(step.world, [](const ConstraintRow&) { return 1.0; });
    for (std::size_t i = 0; i < step.before.size(); ++i) {
        scale += step.before[i].linear_momentum.norm() + step.world.bodies[i].linear_momentum.norm();
    }
    if (change.norm() <= rounding * scale) return {};
    return Broken{"linear momentum", fmt::format("changes by {:.3g} of {:.3g} kg m/s", change.norm(), scale)};
}

// The longest lever of a row about the origin [m].
double lever(const ConstraintRow& row, std::span<const Body> bodies) {
    const double of_a =
        row.jacobian.a.tail<3>().norm() + bodies[static_cast<std::size_t>(row.body_a)].position.norm();
    const double of_b =
        row.jacobian.b.tail<3>().norm() + bodies[static_cast<std::size_t>(row.body_b)].position.norm();
    return of_a + of_b;
}

// Body `i` as it enters the rows of the step: one that was hit (impacts.h) as if it had had the momenta that its
// impacts have left it from the start, from where they take it to the same place.
Body entering(const Step& step, std::size_t i) {
    Body body = step.before[i];
    const auto number = static_cast<int>(i);
    if (!step.world.impacts ||
        std::ranges::find(step.world.impacts->followed(), number) == step.world.impacts->followed().end())
        return body;
    const engine::Flight& flight = step.world.impacts->flight_of(number);
    const double dt = step.world.system().dt;
    body.linear_momentum = flight.linear_momentum();
    body.angular_momentum = flight.angular_momentum();
    const Vector3 momentum = body.linear_momentum + dt * step.world.bodies[i].force;
    body.position = flight.end().position - (dt * body.inverse_mass) * momentum;
    return body;
}

std::optional<Broken> angular_momentum(const Step& step) {
    Vector3 change = engine::angular_momentum(step.world.bodies) - engine::angular_momentum(step.before);
    const double dt = step.world.system().dt;
    double scale =
        dt * sum_of_forces(step.world, [&](const ConstraintRow& row) { return lever(row, step.before); });
    for (std::size_t i = 0; i < step.before.size(); ++i) {
        const Body before = entering(step, i);
        const Body& after = step.world.bodies[i];
        scale += before.angular_momentum.norm() + after.angular_momentum.norm();
        scale += (before.position.norm() + after.position.norm()) *
                 (before.linear_momentum.norm() + after.linear_momentum.norm());
        const Vector3 correction = after.position - before.position - dt * velocity(after);
        if (step.shifts) change -= correction.cross(after.linear_momentum);
    }
    if (change.norm() <= rounding * scale) return {};
    return Broken{"angular momentum", fmt::format("changes by {:.3g} of {:.3g} kg m^2/s", change.norm(), scale)};
}

// Kinetic energy with the inverse inertia of the beginning of the step.
double kinetic(const engine::InverseMass& inverse, const Vector3& p, const Vector3& l) {
    return 0.5 * inverse.linear * p.squaredNorm() + 0.5 * l.dot(inverse.angular * l);
}

// The terms of q for given forces, with the sum of their magnitudes.
struct Objective {
    double value = 0.0;  // dt^2 q, J
    double scale = 0.0;  // J
};

// Of the rows of one island.
template <typename ForceOf>
Objective objective(const SystemEquation& system, const engine::Island& island, ForceOf force_of) {
    std::vector<Vector6> forces(system.inverse_mass.size(), Vector6::Zero());
    const Eigen::Index last = system.column_count() - 1;
    Objective q;
    const double dt2 = system.dt * system.dt;
    for (const engine::RowRun& run : island.runs) {
        for (Eigen::Index j = run.begin; j < run.end; ++j) {
            const ConstraintRow& row = system.rows[at(j)];
            const double force = force_of(j);
            forces[static_cast<std::size_t>(row.body_a)] += row.jacobian.a * force;
            forces[static_cast<std::size_t>(row.body_b)] += row.jacobian.b * force;
            q.value -= dt2 * system.b(j, last) * force;
            q.value += 0.5 * dt2 * row.softness * force * force;
            q.scale += dt2 * (std::abs(system.b(j, last) * force) + system.diagonal(j) * force * force);
        }
    }
    for (std::size_t i = 0; i < forces.size(); ++i) {
        q.value += 0.5 * dt2 * forces[i].dot(engine::accelerate(system.inverse_mass[i], forces[i]));
    }
    return q;
}

std::optional<Broken> energy(const Step& step) {
    const SystemEquation& system = step.world.system();
    double gain = 0.0, scale = 0.0;
    for (std::size_t i = 0; i < step.before.size(); ++i) {
        const Body before = entering(step, i);
        const Body& after = step.world.bodies[i];
        const Vector3 p = before.linear_momentum + system.dt * after.force;
        const Vector3 l = before.angular_momentum + system.dt * after.torque;
        const double without = kinetic(system.inverse_mass[i], p, l);
        const double with = kinetic(system.inverse_mass[i], after.linear_momentum, after.angular_momentum);
        gain += with - without;
        scale += with + without;
    }
    const Eigen::Index last = system.column_count() - 1;
    const auto answer = [&](Eigen::Index j) { return step.world.lambda()(j, last); };
    for (Eigen::Index j = 0; j < system.row_count(); ++j) {
        gain -= system.dt * answer(j) * (system.rows[at(j)].push.lasting + system.carried_by(at(j)));
    }
    // In small steps a gap closes at any speed, and may be closed when its force acts; and of the push, which for
    // contacts is at most the speed of a step's external forces, sweeps may leave something in the momenta.
    for (const engine::Island& island : step.world.islands().all()) {
        if (step.world.outcome_of(island).method != engine::IslandSolver::Method::in_small_steps) continue;
        const double fastest = engine::choice::speed_by_forces(system.dt, step.world.bodies, island);
        for (const engine::RowRun& run : island.runs) {
            for (int j = run.begin; j < run.end; ++j) {
                gain += std::min(
                    0.0, system.dt * answer(j) * (system.rows[at(j)].push.lasting + system.carried_by(at(j))));
                const ConstraintRow& row = system.rows[at(j)];
                if (row.correction && row.correction->kind == engine::PushKind::curve)
                    gain -= std::max(0.0, system.dt * answer(j) * row.push.correcting);
                if (system.rows[at(j)].bounds.of_row < 0) {
                    gain -= system.dt * std::abs(step.world.lambda()(j, 0)) * fastest;
                }
            }
        }
    }
    // Each island may gain what its own guess adds; islands do not compensate each other. The bounds may have
    // changed since the cached forces were a solution.
    double start = 0.0;
    for (const engine::Island& island : step.world.islands().all()) {
        const Objective cached =
            objective(system, island, [&](Eigen::Index j) { return system.rows[at(j)].guess.last; });
        const Objective clamped = objective(system, island, [&](Eigen::Index j) {
            const ConstraintRow& row = system.rows[at(j)];
            return std::clamp(row.guess.last, row.bounds.c_min, row.bounds.c_max);
        });
        // In small steps it acts twice: in the first one, and in the guess of the next one.
        const double times =
            step.world.outcome_of(island).method == engine::IslandSolver::Method::in_small_steps ? 2.0 : 1.0;
        start += times * std::max({0.0, cached.value, clamped.value});
        scale += objective(system, island, answer).scale + cached.scale;
    }
    const double allowed = start + rounding * scale;
    if (gain <= allowed) return {};
    return Broken{"energy", fmt::format("{:.3g} J more than the push gives, of {:.3g} J; {:.3g} J from the guess",
                                        gain, scale, start)};
}

}  // namespace

std::optional<Broken> broken_bounds(const engine::World& world) {
    const SystemEquation& system = world.system();
    for (Eigen::Index c = 0; c < world.lambda().cols(); ++c) {
        for (Eigen::Index j = 0; j < world.lambda().rows(); ++j) {
            const auto [low, high] = bounds_of(world.rows()[at(j)], world.lambda(), c);
            double force = world.lambda()(j, c);
            if (world.rows()[at(j)].bounds.disc == engine::Disc::second) {
                force = std::hypot(world.lambda()(j - 1, c), force);
            }
            const double beyond = std::max({0.0, low - force - smallest, force - high - smallest});
            // A guess is kept as long as it moves nothing faster than the tolerance.
            const double left_open =
                world.termination.tolerance_high + rounding * system.dt * system.diagonal(j) * std::abs(force);
            if (beyond * system.dt * system.diagonal(j) <= left_open) continue;
            return Broken{"bounds",
                          fmt::format("row {} column {}: {} N is not within {} .. {} N", j, c, force, low, high)};
        }
    }
    return {};
}

std::optional<Broken> broken_claim(const Step& step) {
    if (auto broken = broken_bounds(step.world)) return broken;
    if (step.isolated) {
        if (auto broken = linear_momentum(step)) return broken;
    }
    if (step.isolated && !step.swept) {
        if (auto broken = angular_momentum(step)) return broken;
    }
    return step.monotone ? energy(step) : std::nullopt;
}

}  // namespace pushfactor::tests
