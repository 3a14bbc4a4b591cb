#include "engine/step/small_step_rules.h"

#include <algorithm>

namespace pushfactor::engine::small_step_rules {

namespace {

// Divisions of a step: for islands that have to carry load, which jitter persistently with two sweeps per small
// step; for islands that move with little load, or are hit in some places; and for islands that move and are hit
// everywhere.
constexpr SmallStepDivision carrying{.steps = 16, .sweeps = 4};
constexpr SmallStepDivision moving_on{.steps = 16, .sweeps = 2};
constexpr SmallStepDivision stirred{.steps = 8, .sweeps = 2};
// Shares of moving bodies above which an island is not standing, and is stirred.
constexpr double a_few_move = 0.05, a_part_moves = 0.25;

// Residual at which an island has settled, as a share of the speed that external forces add per step.
constexpr double settled = 1e-3;

// The same: largest residual due to missing forces, with room for rounding.
constexpr double unbalanced = 1.1;

// The same: residual above which bodies hit each other; more than unsupported load can build up in some steps.
constexpr double hit = 3.0;

// The same: residual up to which hardly any load is unsupported.
constexpr double unheld = 0.1;

// Sweeps of a whole step spread load over a number of layers that is the square root of their number.
constexpr int few = 6;

// Number of bodies faster than the speed that one step of their external force gives them.
int moving(double dt, std::span<const Body> bodies, const Island& island) {
    return static_cast<int>(std::count_if(island.bodies.begin(), island.bodies.end(), [&](int body) {
        const Body& own = bodies[static_cast<std::size_t>(body)];
        return own.linear_momentum.squaredNorm() > dt * dt * own.force.squaredNorm();
    }));
}

bool is_more_than(double share, int bodies, const Island& island) {
    return bodies > share * island.movable();
}

// Largest speed that the external forces of a step give a body [m/s].
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
    if (!suit(island)) return infinity;
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
