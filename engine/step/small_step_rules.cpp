#include "engine/step/small_step_rules.h"

#include <algorithm>
#include <limits>

namespace pushfactor::engine::small_step_rules {

namespace {

// What is to carry load, which with two sweeps a step trembles for ever; what moves with little to carry, or is hit
// somewhere; and what moves and is hit everywhere.
constexpr SmallStepDivision carrying{.steps = 16, .sweeps = 4};
constexpr SmallStepDivision moving_on{.steps = 16, .sweeps = 2};
constexpr SmallStepDivision stirred{.steps = 8, .sweeps = 2};
// Shares of its bodies that move, beyond which an island no longer stands, and is stirred.
constexpr double a_few_move = 0.05, a_part_moves = 0.25;

// Residual with which an island has settled, as a share of the speed that external forces give in a step.
constexpr double settled = 1e-3;

// And with which forces are missing at most, with room for roundings.
constexpr double unbalanced = 1.1;

// And with which bodies hit each other: more than load that is not held can build up in some steps.
constexpr double hit = 3.0;

// And up to which hardly any load is not held.
constexpr double unheld = 0.1;

// Sweeps of a whole step spread load over as many layers as the root of their number.
constexpr int few = 6;

// How many bodies are faster than one step of their external force makes them.
int moving(double dt, std::span<const Body> bodies, const Island& island) {
    return static_cast<int>(std::count_if(island.bodies.begin(), island.bodies.end(), [&](int body) {
        const Body& own = bodies[static_cast<std::size_t>(body)];
        return own.linear_momentum.squaredNorm() > dt * dt * own.force.squaredNorm();
    }));
}

bool is_more_than(double share, int bodies, const Island& island) {
    return bodies > share * island.movable();
}

// The largest speed that the external forces of a step give to a body [m/s].
double fastest_by_forces(double dt, std::span<const Body> bodies, const Island& island) {
    double fastest = 0.0;
    for (const int body : island.bodies) {
        const Body& own = bodies[static_cast<std::size_t>(body)];
        fastest = std::max(fastest, own.inverse_mass * own.force.norm());
    }
    return dt * fastest;
}

bool suit(const Island& island) {
    return island.movable() >= few && !island.has(RowDigest::acts_both_ways) && !island.has(RowDigest::rebounds);
}

}  // namespace

double largest_to_sweep(double dt, std::span<const Body> bodies, const Island& island) {
    if (!suit(island)) return std::numeric_limits<double>::infinity();
    return settled * fastest_by_forces(dt, bodies, island);
}

double standing_speed(double dt, std::span<const Body> bodies, const Island& island) {
    if (is_more_than(a_few_move, moving(dt, bodies, island), island)) return 0.0;
    return unbalanced * fastest_by_forces(dt, bodies, island);
}

SmallStepDivision division_of(double dt, std::span<const Body> bodies, const Island& island, double residual) {
    const double by_forces = fastest_by_forces(dt, bodies, island);
    const int moves = moving(dt, bodies, island);
    const bool mostly = is_more_than(a_part_moves, moves, island);
    if (residual <= unheld * by_forces) return mostly ? moving_on : carrying;
    if (residual <= hit * by_forces || !is_more_than(a_few_move, moves, island)) return carrying;
    return mostly ? stirred : moving_on;
}

}  // namespace pushfactor::engine::small_step_rules
