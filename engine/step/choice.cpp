#include "engine/step/choice.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine::choice {

namespace {

// Share of the bodies that move above which an island is a heap, and no structure that stands.
constexpr double a_part = 0.02;

constexpr SmallStepDivision moving{.steps = 8, .sweeps = 1}, carrying{.steps = 16, .sweeps = 1};

// The more, the smaller a body and the larger its force: a body at rest is compressed by at most so much of its
// radius of gyration; up to a limit.
constexpr double compressed = 0.01, most_steps = 1000.0;

// What a direct solution is worth, in sweeps over the rows: twice the small steps that carry load. Where an island
// stands, and has no forces yet or nearly the right ones, the solution lasts, and is worth what a wall of 200
// bricks takes.
constexpr double sweeps = 64.0, sweeps_that_last = 1500.0;
// Limits on multiply-adds: of what moves, whose forces do not last; of what stands, so that no step takes longer
// than some 50 ms and none after the first than some 5 ms.
constexpr double most_of_moving = 4e5, most_of_standing = 2e8, most_again = 2e7;
// A few bodies that stand are always worth so many.
constexpr double least_of_standing = 6e5;
// The same per body, for islands that take no small steps; for joints, which forces far from the solution pull
// apart; and for bars alone, which one factorisation solves.
constexpr double of_a_body = 2e5, of_a_body_on_bars = 2e4;
// Residuals up to which forces are nearly right, and up to which they are as good as right, over the speed that the
// external forces of a step cause.
constexpr double near = 1e-3, good = 1e-6;

// Share of the lower tolerance up to which a guess leaves what stands where it is. A body goes on with what moves
// it if it is as fast as that share of the residual.
constexpr double at_rest = 0.01, as_fast = 0.1;

// A body moves if it is faster than the speed that so many steps of its external force give it: no whole number,
// which a body that has just begun to fall would have but for rounding.
constexpr double steps_of_force = 1.5;

int count_moving(double dt, std::span<const Body> bodies, const Island& island) {
    return static_cast<int>(std::count_if(island.bodies.begin(), island.bodies.end(), [&](int body) {
        const Body& own = bodies[static_cast<std::size_t>(body)];
        return own.linear_momentum.norm() > steps_of_force * dt * own.force.norm();
    }));
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

// Whether none of its bodies is faster than its external force makes it in this step.
bool stands(double dt, std::span<const Body> bodies, const Island& island) {
    return count_moving(dt, bodies, island) == 0;
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

SmallStepDivision division_of(double dt, std::span<const Body> bodies, const Island& island) {
    SmallStepDivision division = count_moving(dt, bodies, island) > a_part * island.movable() ? moving : carrying;
    double most = 0.0;  // 1/s^2, acceleration over allowed compression
    for (const int body : island.bodies) {
        const Body& own = bodies[static_cast<std::size_t>(body)];
        const double radius = std::sqrt(own.inverse_mass / own.inverse_inertia.maxCoeff());  // m, of gyration
        most = std::max(most, own.inverse_mass * own.force.norm() / (compressed * radius));
    }
    const double wanted = std::ceil(dt * std::sqrt(most));
    division.steps = std::max(division.steps, static_cast<int>(std::min(wanted, most_steps)));
    return division;
}

bool will_do(double residual, const solvers::Termination& usual, std::span<const Body> bodies,
             const Island& island) {
    if (residual <= at_rest * usual.tolerance_low) return true;
    return residual <= usual.tolerance_high &&
           std::any_of(island.bodies.begin(), island.bodies.end(), [&](int body) {
               const Body& own = bodies[static_cast<std::size_t>(body)];
               const double turning = own.inverse_inertia.maxCoeff() * own.angular_momentum.squaredNorm();
               const double energies = own.inverse_mass * own.linear_momentum.squaredNorm() + turning;  // twice, J
               return std::sqrt(own.inverse_mass * energies) >= as_fast * residual;
           });
}

double good_residual(double dt, std::span<const Body> bodies, const Island& island) {
    return good * speed_by_forces(dt, bodies, island);
}

double worth_of(double dt, std::span<const Body> bodies, const Island& island, double residual, bool has_forces,
                bool divided) {
    const bool standing = stands(dt, bodies, island);
    const bool lasts = standing && (!has_forces || residual <= near * speed_by_forces(dt, bodies, island));
    const double as_many = standing ? sweeps * mass_ratio(bodies, island) : sweeps;
    const double of_sweeps =
        (lasts ? sweeps_that_last : std::min(as_many, sweeps_that_last)) * 24.0 * island.columns * island.rows;
    const double most = !standing ? most_of_moving : has_forces ? most_again : most_of_standing;
    const bool needs_it = !divided || island.has(RowDigest::joins) || !island.has(RowDigest::limited);
    const double of_body = needs_it ? of_a_body : island.has(RowDigest::acts_both_ways) ? of_a_body_on_bars : 0.0;
    const double least = std::max(standing ? least_of_standing : 0.0, of_body * island.movable());
    return std::max(std::min(of_sweeps, most), least);
}

}  // namespace pushfactor::engine::choice
