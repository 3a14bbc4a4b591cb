// True errors of runs: against closed forms, exact motion or converged forces, never against another program or a
// finer run.
#pragma once

#include "demos/runs/simulation.h"

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace pushfactor::demos::reports::error {

// Root of the mean of squares.
class Rms {
  public:
    void add(double square) {
        sum_ += square;
        ++count_;
    }
    double value() const { return count_ > 0 ? std::sqrt(sum_ / static_cast<double>(count_)) : 0.0; }

  private:
    double sum_ = 0.0;
    long count_ = 0;
};

struct NamedError {
    std::string name;  // with its unit, "sideways_m"; without one it is relative
    double value = 0.0;
};

class TrueError {
  public:
    virtual ~TrueError() = default;
    virtual void observe(const Simulation& simulation) = 0;  // after each step
    virtual std::vector<NamedError> result() const = 0;      // the plotted one first
};
using MakeTrueError = std::function<std::unique_ptr<TrueError>(const Simulation& start)>;

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
std::unique_ptr<TrueError> rest_error(const Simulation& start);

// Structures that should stand: distance from the start, RMS over the bodies and the last second.
std::unique_ptr<TrueError> standing_error(const Simulation& start);

// Intersecting stack: distance from PartingCube, over all steps and cubes.
std::unique_ptr<TrueError> parting_error(const Simulation& start);

// The scene's own measure: for the wave the angle against the exact motion of two angles.
std::unique_ptr<TrueError> scene_error(const Simulation& start);

// A column of equal touching balls: e_f of the first step, whose exact forces are the weights above.
std::unique_ptr<TrueError> column_error(const Simulation& start);

// The chain: distance of the balls from the exact motion, over all steps.
std::unique_ptr<TrueError> chain_error(const Simulation& start);

// Piles: the deepest overlap, the median of the steps; its largest value.
std::unique_ptr<TrueError> overlap_error(const Simulation& start);

// Free bodies: distance of the corners of boxes from the exact motion, over all steps; its parts due to flight (of
// all bodies) and to rotation, and the largest relative change of rotational energy. Throws engine::InvalidInput
// for a box whose motion scenes::FreeRotation does not cover.
std::unique_ptr<TrueError> free_error(const Simulation& start);

// Everything else: the median of e_f against converged forces of the same system, over thirty moments of the run.
std::unique_ptr<TrueError> converged_error(const Simulation& start);

}  // namespace pushfactor::demos::reports::error
