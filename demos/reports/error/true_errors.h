// True errors of runs: against closed forms, exact motion or converged forces, never against another program or a
// finer run.
#pragma once

#include "demos/runs/simulation.h"

#include <functional>
#include <string>
#include <vector>

namespace pushfactor::demos::reports::error {

struct NamedError {
    std::string name;  // with its unit, "sideways_m"; without one it is relative
    double value = 0.0;
};

// One number of what is added to it over the steps of a run, 0 of nothing.
class ErrorNumber {
  public:
    enum Kind { root_mean, largest, middle, last, sum };  // root_mean: of squares

    ErrorNumber(std::string name, Kind kind) : name_(std::move(name)), kind_(kind) {}
    void add(double value);
    NamedError result() const;

  private:
    std::string name_;
    Kind kind_;
    double value_ = 0.0;
    long count_ = 0;
    std::vector<double> all_;  // for the median
};
using ErrorNumbers = std::vector<ErrorNumber>;

struct TrueError {
    ErrorNumbers numbers;  // the plotted one first
    std::function<void(const Simulation& now, ErrorNumbers& numbers)> look;

    void observe(const Simulation& now) { look(now, numbers); }  // after each step
    std::vector<NamedError> result() const;
};
using MakeTrueError = std::function<TrueError(const Simulation& start)>;

// Reference forces: the same system solved down to a negligible residual.
//
//   e_f = sqrt( (lambda - lambda*)^T A (lambda - lambda*) / (lambda*^T A lambda*) )
//
// the relative error of the accelerations that the constraint forces give. Box on box has more contacts than
// unknown reactions, so lambda* is not unique; A lambda* is, and e_f sees nothing else.
//
// Symbols: A = J M^-1 J^T [1/kg], lambda answer and lambda* converged answer [N], e_f [1].
//
// e_f, the largest over the columns. None if the converged forces are zero.
std::optional<double> force_error(const engine::SystemEquation& system, const engine::Columns& lambda,
                                  const engine::Columns& converged);

// The converged forces of at most 1e-10 m/s (natural map), starting from `guess`. None if no solver converges.
std::optional<engine::Columns> converged_forces(const engine::SystemEquation& system, const engine::Columns& guess);

// Closed form of one of the parting cubes after `steps` engine steps, with everything solved exactly.
struct PartingCube {
    double start = 0.0;  // m, height of the centre
    double rest = 0.0;   // m, height without overlap
    engine::Correction push;
    double dt = 0.0;        // s, of an engine step
    double gravity = 10.0;  // m/s^2

    // Of the centre. Persistent: all leave with beta (rest - start) / dt in the first step and fly. Single-frame:
    // the distance to the rest height shrinks by the factor 1 - beta per step. No push: it stays.
    double height(long steps) const;
    double upward_speed(long steps) const;  // m/s, stored velocity
};

// Force of the row between body `lower` and the one above it in a column of equal balls at rest [N].
double weight_above(int lower, int count, double mass, double gravity);

// Stack: distance from the exact rest positions and error of the force below the lowest cube, over the last second;
// the largest sideways motion, zero if solved exactly, over the run. Valid for a jittered stack too: while the
// common centre of mass of everything above a face is above that face, forces at its corners can stop the fall
// without rotation, and the velocities of an exact solution are unique. So each cube lands straight below its
// start.
TrueError rest_error(const Simulation& start);

// Structures that should stand: distance from the start, RMS over the bodies and the last second.
TrueError standing_error(const Simulation& start);

// Intersecting stack: distance from PartingCube, over all steps and cubes.
TrueError parting_error(const Simulation& start);

// The scene's own measure: for the wave the angle against the exact motion of two angles.
TrueError scene_error(const Simulation& start);

// A column of equal touching balls: e_f of the first step, whose exact forces are the weights above.
TrueError column_error(const Simulation& start);

// The chain: distance of the balls from the exact motion of balls on massless bars, over all steps.
TrueError chain_error(const Simulation& start);

// Piles: the deepest overlap, the median of the steps; its largest value.
TrueError overlap_error(const Simulation& start);

// Free bodies: distance of the corners of boxes from the parabola and the closed form of free rotation, over all
// steps; its parts due to flight (of all bodies) and to rotation, and the largest relative change of rotational
// energy. Throws engine::InvalidInput for a box whose motion scenes::FreeRotation does not cover.
TrueError free_error(const Simulation& start);

// Everything else: the median of e_f against converged forces of the same system, over thirty moments of the run.
TrueError converged_error(const Simulation& start);

}  // namespace pushfactor::demos::reports::error
