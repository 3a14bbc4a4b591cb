// How an island is solved in a step: directly, or in small steps, and how many. Every rule uses the island and its
// state alone, and no memory of earlier steps. Speeds are those relative to the moved body that the island is on,
// so that a tower in a lift is solved as one on the ground.
//
//   - An island whose guess is good enough is not solved (island_solver.h).
//   - It is solved directly where it stands, if the solution lasts or a few bodies make it cheap; and where nothing
//     else serves: loops of joints, mechanisms that touch nothing, islands that take no small steps, and masses so
//     unequal that load does not pass in small steps, where that is cheap: towers and crates, not a wall that a
//     heavy ball hits. A solution that lasts and costs more is looked for by sweeps of the whole step.
//   - Everything else takes small steps, more of them the larger the forces are for a body's size, because what
//     carries load is compressed by g h^2.
#pragma once

#include "engine/bodies/body.h"
#include "engine/step/small_steps.h"
#include "engine/system/islands.h"

#include <span>

namespace pushfactor::engine::choice {

// Whether small steps suit the island. A single body is always solved directly; and a row that bounces would bounce
// again in the next small step.
bool divides(const Island& island);

// Largest speed that the external forces of a step give a body [m/s].
double speed_by_forces(double dt, std::span<const Body> bodies, const Island& island);

SmallStepDivision division_of(const SystemEquation& system, std::span<const Body> bodies, const Island& island);

// Whether a guess with this residual [m/s] is kept. Below the upper tolerance it may go on with what moves, but
// must not set in motion what stands: else a solution that stops a body would push it back in the next step, for
// ever.
bool will_do(double residual, const solvers::Termination& usual, const SystemEquation& system,
             std::span<const Body> bodies, const Island& island);

// Residual [m/s] of a direct solution that is taken although it misses the tolerance: far less than small steps
// leave.
double good_residual(double dt, std::span<const Body> bodies, const Island& island);

// Multiply-adds that a direct solution of the island is worth, whose guess has forces or none and these residuals
// [m/s] in its columns, the factorisations that it is expected to take, and those that it may take in any case once
// it is begun. `divided`: small steps are taken instead, else sweeps of the whole step; `has_loops`: of joints.
// `sweeps` are tried before small steps where it costs more, and lasts: in the worth of the first forces, and as
// many as small steps where these are nearly right. A pyramid that stands on forces that are kept leans three times
// as far in each step, box by box, and a few sweeps put it straight.
struct Worth {
    double multiply_adds = 0.0, factorisations = 0.0, at_least = 0.0;
    int sweeps = 0;
};
Worth worth_of(const SystemEquation& system, std::span<const Body> bodies, const Island& island,
               std::span<const double> residuals, bool has_forces, bool divided, bool has_loops);

}  // namespace pushfactor::engine::choice
