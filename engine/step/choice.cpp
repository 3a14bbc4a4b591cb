#include "engine/step/choice.h"

#include "engine/base/constants.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine::choice {

using namespace constants::choice;

namespace {

// What the bodies of an island are at rest on: a moved body, or, where anything static touches them, the world.
struct Ground {
    Vector3 position = Vector3::Zero();  // m
    Motion motion{};
};

Ground ground_of(const SystemEquation& system, std::span<const Body> bodies, const Island& island) {
    Ground ground;
    if (system.carried.empty()) return ground;
    for (const RowRun& run : island.runs) {
        const ConstraintRow& row = system.rows[static_cast<std::size_t>(run.begin)];
        for (const int number : {row.body_a, row.body_b}) {
            const Body& body = bodies[static_cast<std::size_t>(number)];
            if (!body.is_static()) continue;
            if (!body.is_moved()) return {};
            if (ground.motion.is_none()) ground = {body.position, body.prescribed};
        }
    }
    return ground;
}

// Momenta relative to what it is at rest on [kg m/s, kg m^2/s].
struct Momenta {
    Momenta(const Body& body, const Ground& ground) : linear(body.linear_momentum), angular(body.angular_momentum) {
        if (ground.motion.is_none()) return;
        const auto& [velocity, spin] = ground.motion;
        linear -= body.mass() * (velocity + spin.cross(body.position - ground.position));
        angular -= world_inertia(body) * spin;
    }
    Vector3 linear, angular;
};

// Whether none of its bodies is faster than its external force makes it in this step.
bool stands(const SystemEquation& system, std::span<const Body> bodies, const Island& island) {
    const Ground ground = ground_of(system, bodies, island);
    return std::none_of(island.bodies.begin(), island.bodies.end(), [&](int body) {
        const Body& own = bodies[static_cast<std::size_t>(body)];
        return Momenta(own, ground).linear.norm() > steps_of_force * system.dt * own.force.norm();
    });
}

double mass_ratio(std::span<const Body> bodies, const Island& island) {
    double largest = 0.0, smallest = infinity;  // 1/kg
    for (const int body : island.bodies) {
        const double inverse_mass = bodies[static_cast<std::size_t>(body)].inverse_mass;
        largest = std::max(largest, inverse_mass);
        smallest = std::min(smallest, inverse_mass);
    }
    return largest / smallest;
}

// Largest speed of a body whose whole kinetic energy were that of its mass centre [m/s].
double fastest(const SystemEquation& system, std::span<const Body> bodies, const Island& island) {
    const Ground ground = ground_of(system, bodies, island);
    double most = 0.0;
    for (const int body : island.bodies) {
        const Body& own = bodies[static_cast<std::size_t>(body)];
        const Momenta momenta(own, ground);
        const double turning = own.inverse_inertia.maxCoeff() * momenta.angular.squaredNorm();
        const double energies = own.inverse_mass * momenta.linear.squaredNorm() + turning;  // twice, J
        most = std::max(most, own.inverse_mass * energies);
    }
    return std::sqrt(most);
}

}  // namespace

bool divides(const Island& island) {
    return island.movable() > 1 && !island.has(RowDigest::rebounds);
}

double speed_by_forces(double dt, std::span<const Body> bodies, const Island& island) {
    double fastest = 0.0;
    for (const int body : island.bodies) {
        const Body& own = bodies[static_cast<std::size_t>(body)];
        fastest = std::max(fastest, own.inverse_mass * own.force.norm());
    }
    return dt * fastest;
}

SmallStepDivision division_of(const SystemEquation& system, std::span<const Body> bodies, const Island& island) {
    double most = 0.0;  // 1/s^2, acceleration over allowed compression
    for (const int body : island.bodies) {
        const Body& own = bodies[static_cast<std::size_t>(body)];
        const double radius = std::sqrt(own.inverse_mass / own.inverse_inertia.maxCoeff());  // m, of gyration
        most = std::max(most, own.inverse_mass * own.force.norm() / (compressed * radius));
    }
    const double wanted = std::ceil(system.dt * std::sqrt(most));
    return {.steps = std::max(fewest_steps, static_cast<int>(std::min(wanted, most_steps))), .sweeps = 1};
}

bool will_do(double residual, const solvers::Termination& usual, const SystemEquation& system,
             std::span<const Body> bodies, const Island& island) {
    if (residual <= at_rest * usual.tolerance_low) return true;
    return residual <= usual.tolerance_high && fastest(system, bodies, island) >= as_fast * residual;
}

double good_residual(double dt, std::span<const Body> bodies, const Island& island) {
    return good * speed_by_forces(dt, bodies, island);
}

Worth worth_of(const SystemEquation& system, std::span<const Body> bodies, const Island& island,
               std::span<const double> residuals, bool has_forces, bool divided, bool has_loops) {
    const bool standing = stands(system, bodies, island), limited = island.has(RowDigest::limited);
    const double near_one = near * speed_by_forces(system.dt, bodies, island);
    // What it stands on changes with what moves: forces that are nearly right stay so where speeds are as small as
    // they are wrong. Where neither speeds nor pushes move anything, they are those of the step that stopped it.
    const auto stays = [&] {
        const double residual = residuals.back(), speed = fastest(system, bodies, island);
        return std::max(residual, speed) <= near_one || (island.columns == 1 && speed < as_fast * residual);
    };
    const bool lasts = standing && (!has_forces || stays());
    const int steps = division_of(system, bodies, island).steps;
    const double ratio = mass_ratio(bodies, island);
    const double sweeps = sweeps_of_a_step * steps * ratio;
    const double worth = lasts ? sweeps_that_last : standing ? std::min(sweeps, sweeps_that_last) : 0.0;
    const double of_sweep = 24.0 * island.columns * island.rows, of_sweeps = worth * of_sweep;
    const double most = most_work * std::max(1.0, island.movable() / bodies_of_limits);
    const bool needs_it = !divided || has_loops || !island.has(RowDigest::opens);
    const double of_body = needs_it ? of_a_body : island.has(RowDigest::acts_both_ways) ? of_a_body_on_bars : 0.0;
    const bool passes = ratio <= steps;  // load, in the solves of so many small steps
    const double of_few = !passes || (standing && island.movable() <= few) ? few * of_a_body : 0.0;
    const double least = std::max(of_few, of_body * island.movable());
    const double multiply_adds = std::max(std::min(of_sweeps, most), least);
    return {.multiply_adds = multiply_adds,
            .factorisations = lasts || !limited ? when_near : from_afar,
            .at_least = lasts ? at_worst : 0.0,
            .sweeps = !lasts       ? 0
                      : has_forces ? steps
                                   : static_cast<int>(multiply_adds / of_sweep)};
}

}  // namespace pushfactor::engine::choice
