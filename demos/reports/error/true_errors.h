// Errors of runs against something true: closed forms, the exact motion, converged forces. Never against another
// program, and never against a finer run of the same.
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
    virtual std::vector<NamedError> result() const = 0;      // the one that is plotted first
};
using MakeTrueError = std::function<std::unique_ptr<TrueError>(const Simulation& start)>;

// Of cubes that part: where the centre of one is after `steps` engine steps, when everything is solved exactly.
struct PartingCube {
    double start = 0.0;  // m, height of the centre
    double rest = 0.0;   // m, where it stands when nothing overlaps
    engine::Correction push;
    double dt = 0.0;        // s, of an engine step
    double gravity = 10.0;  // m/s^2

    // Persistent: all leave with beta (rest - start) / dt in the first step and fly. Single-frame: what is left to
    // the rest shrinks by 1 - beta a step. No push: it stays.
    double height(long steps) const;
    double upward_speed(long steps) const;  // m/s, stored velocity
};

// What the row between body `lower` and the one above it carries in a column of equal balls at rest [N].
double weight_above(int lower, int count, double mass, double gravity);

// Stack: distance from where the cubes must rest and error of the force below the lowest, over the last second; the
// largest way sideways, which exactly solved stays zero, over the run. True for a jittered stack too: while the
// centre of all that lies on a face is above that face, pushes at its corners alone stop the fall without a turn,
// and the velocities of an exact answer are unique. So each cube comes down on the place below its start.
std::unique_ptr<TrueError> rest_error(const Simulation& start);

// What stands where it was built: the distance from there, RMS over the bodies and the last second.
std::unique_ptr<TrueError> standing_error(const Simulation& start);

// Intersecting stack: distance from the closed form above, over all steps and cubes.
std::unique_ptr<TrueError> parting_error(const Simulation& start);

// What the scene itself measures against its reference: the wave's angle against the exact motion of two angles.
std::unique_ptr<TrueError> scene_error(const Simulation& start);

// A column of equal balls that touch: e_f of the first step, whose exact forces are the weights above.
std::unique_ptr<TrueError> column_error(const Simulation& start);

// Bodies that nothing touches: distance of the corners of boxes from the exact motion, over all steps; the parts of
// it that are due to flight (of all bodies) and to rotation, and the largest relative change of the energy of
// rotation. Throws engine::InvalidInput for a box whose motion scenes::FreeRotation leaves out.
std::unique_ptr<TrueError> free_error(const Simulation& start);

// Everything else: the median of e_f against converged forces of the same system, over thirty moments of the run.
std::unique_ptr<TrueError> converged_error(const Simulation& start);

}  // namespace pushfactor::demos::reports::error
