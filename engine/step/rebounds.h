// Rebounds that make no energy. Newton's law of restitution (8.2.1) with friction can: where friction turns the
// sliding around, the impulse of the rebound works in the direction in which the point then moves (Kane 1984,
// Stronge 1990). So the work of an impact between two bodies may not be positive:
//
//   W = sum over the rows of the pair of P (w + w') / 2 <= 0
//
// Symbols: P impulse of a row [N s], in the column that sets momenta; w and w' velocities along the row before and
// after the impact, relative to what moves the surfaces [m/s].
//
// W is zero at most where nothing rebounds. Bounds are convex, so between the solution without and the one with
// rebounds, P(k) = P(0) + k (P(1) - P(0)), everything keeps its bounds, and W is quadratic in k: the largest k from
// 0 to 1 that makes no energy is taken for the whole island.
#pragma once

#include "engine/step/small_steps.h"
#include "engine/system/islands.h"
#include "engine/system/system_equation.h"

#include <span>
#include <vector>

namespace pushfactor::engine {

// Of one solution: impulse and mean velocity of each contact and friction row of pairs that rebound, in the order
// of the island.
class ImpactWork {
  public:
    // The forces are those of `lambda`.
    void find(const SystemEquation& system, std::span<const Body> bodies, const Island& island,
              const Columns& lambda, const ConstraintForces& forces);

    // Whether some pair makes more energy than rounding does.
    bool gains() const;

    // k, for this solution with rebounds and `stopped` without.
    double share_without_gain(const ImpactWork& stopped) const;

  private:
    struct Row {
        int pair = 0;          // number of its run
        double impulse = 0.0;  // P
        double speed = 0.0;    // (w + w') / 2
    };
    std::vector<Row> rows_;
};

// Takes the rebounds out of b: points that meet stop there.
void take_out_rebounds(const Island& island, SystemEquation& system);

}  // namespace pushfactor::engine
