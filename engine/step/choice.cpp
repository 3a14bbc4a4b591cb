#include "engine/step/choice.h"

#include <algorithm>

namespace pushfactor::engine::choice {

namespace {

// Islands of fewer bodies are tried directly also while they move: at six, a direct solution costs as much as the
// small steps.
constexpr int few = 6;

// Shares of the bodies that are faster than their forces make them: up to the first an island stands, above the
// second most of it moves.
constexpr double a_few = 0.05, a_part = 0.25;

constexpr SmallStepDivision moving{.steps = 8, .sweeps = 1}, carrying{.steps = 16, .sweeps = 1};

// What a direct solution is worth, in sweeps over the rows: twice the small steps that carry load. For one that
// lasts: what walls of 400 bricks take.
constexpr double sweeps = 64.0, sweeps_that_last = 1500.0;
// Sweeps converge as slowly as masses differ: where an island stands, a direct solution is worth more by the ratio
// of the largest mass to the smallest, and from this ratio on also the interior point method is.
constexpr double large_ratio = 20.0;
// Factorisations of a column: of the active set alone, and of the interior point method besides, which finds the
// forces of what stands for the first time.
constexpr double changes = 9.0, with_interior_point = 25.0;
// Limit on multiply-adds: no step should take longer than some 50 ms, and no step after the first than some 15 ms.
constexpr double most_of_a_step = 2e8, most_of_a_step_again = 5e7;
// Share of the speed that the external forces of a step cause up to which a guess is near.
constexpr double near = 1e-3;
// The same in multiply-adds per body, for islands that have few rows per body, and for those that take no small
// steps instead.
constexpr double of_a_body = 2e4, of_an_undivided = 2e5;
// The same for mechanisms: forces that are far from the solution pull their joints apart.
constexpr double of_a_jointed_body = 1.5e5;

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

}  // namespace

bool divides(const Island& island) {
    return island.movable() >= few && !island.has(RowDigest::rebounds);
}

bool stands(double dt, std::span<const Body> bodies, const Island& island) {
    return count_moving(dt, bodies, island) <= a_few * island.movable();
}

bool is_tried_directly(double dt, std::span<const Body> bodies, const Island& island) {
    return island.movable() < few || island.has(RowDigest::acts_both_ways) || stands(dt, bodies, island);
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
    return count_moving(dt, bodies, island) > a_part * island.movable() ? moving : carrying;
}

double tolerance_of_guess(const Island& island, const solvers::Termination& usual) {
    return island.movable() < few ? usual.tolerance_low : usual.tolerance_high;
}

void set_worth(double dt, std::span<const Body> bodies, const Island& island, double residual, bool has_forces,
               bool divided, solvers::Termination& termination) {
    const bool near_by = residual <= near * speed_by_forces(dt, bodies, island);
    const bool standing = stands(dt, bodies, island), lasts = standing && (!has_forces || near_by);
    const bool jointed = island.has(RowDigest::joins);
    const double ratio = standing ? mass_ratio(bodies, island) : 1.0;
    const double worth = lasts ? sweeps_that_last : std::min(sweeps * ratio, sweeps_that_last);
    const double of_sweeps = worth * 24.0 * island.columns * island.rows;
    const double most = has_forces ? most_of_a_step_again : most_of_a_step;
    const double of_body = jointed                              ? of_a_jointed_body
                           : !divided || island.movable() < few ? of_an_undivided
                                                                : of_a_body;
    termination.worth = std::max(std::min(of_sweeps, most), of_body * island.movable());
    termination.factorisations = has_forces && divided && !jointed && ratio < large_ratio ? changes
                                 : standing || jointed                                    ? infinity
                                                                                          : with_interior_point;
}

}  // namespace pushfactor::engine::choice
