// Paths of moved bodies: static bodies (3.1) whose motion is prescribed and not computed.
//
// A step sees the mean velocities of such a body in its rows (carried.h); at its end the body is where its path is,
// so that no error adds up. Times closer together than 1e-9 of themselves are the same, because the world's time is
// a sum of steps: what begins at 2 s begins in the step that begins at 2 s.
//
// Not from the paper, whose static bodies never move.
#pragma once

#include "engine/bodies/body.h"

#include <memory>
#include <vector>

namespace pushfactor::engine {

// Position [m] and orientation (body to world, unit length) of a body.
struct Place {
    Vector3 position = Vector3::Zero();
    Quaternion orientation = Quaternion::Identity();
};

// Constant velocities from one place to another in `dt` [s], by less than half a turn.
Motion motion_between(const Place& before, const Place& after, double dt);

class Path {
  public:
    virtual ~Path() = default;

    // Where the body is at `time` [s since the start of the world], world frame. Continuous.
    virtual Place at(double time) const = 0;

    // Mean velocities of the body from `from` until `until` > `from` [s]. By default from the difference of both
    // places, which knows less than half a turn.
    virtual Motion mean(double from, double until) const;
};

// When a path goes on: before and after that the body stands.
struct PathTimes {
    double from = 0.0;        // s, >= 0
    double until = infinity;  // s, >= from

    // Time on the way [s], 0 at `from`.
    double since_start(double time) const;
};

// Constant velocities, about the body's centre.
class SteadyPath : public Path {
  public:
    SteadyPath(const Place& start, const Motion& motion, const PathTimes& times)
        : start_(start), motion_(motion), times_(times) {}

    Place at(double time) const override;
    Motion mean(double from, double until) const override;

  private:
    Place start_;
    Motion motion_;
    PathTimes times_;
};

// A sinusoid that begins at the start: x = x_0 + a (sin(2 pi f t + phi) - sin phi), t = 0 at `times.from`.
class Oscillation : public Path {
  public:
    // `amplitude` a [m, world frame]; `frequency` f [1/s]; `phase` phi [rad].
    Oscillation(const Place& start, const Vector3& amplitude, double frequency, double phase,
                const PathTimes& times)
        : start_(start), amplitude_(amplitude), frequency_(frequency), phase_(phase), times_(times) {}

    Place at(double time) const override;

  private:
    Place start_;
    Vector3 amplitude_;
    double frequency_, phase_;
    PathTimes times_;
};

// A table of places, with constant velocities from each to the next, and the shorter way around. The body starts
// at time 0, and stands from the last one on.
class PlaceTable : public Path {
  public:
    struct Entry {
        double time = 0.0;  // s, above 0 and above that of the entry before
        Place place{};
    };
    PlaceTable(const Place& start, const std::vector<Entry>& entries);

    Place at(double time) const override;
    Motion mean(double from, double until) const override;

  private:
    struct Leg {
        double begin, end;  // s
        Place from, to;
        Vector3 turn;  // rad, rotation vector
    };
    std::vector<Leg> legs_;
};

}  // namespace pushfactor::engine
