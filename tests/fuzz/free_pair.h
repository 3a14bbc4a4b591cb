// Two bodies on which nothing acts, followed exactly: whether, when and with which normal they touch.
//
// The motion. Nothing pushes, so momenta stay; a step of the engine moves positions by dt p / m and turns bodies as
// rotate_by_small_turns does. Within a step two motions are taken for the free one: `steady`, the uniform turn from
// the pose before to the pose after the step, which is what the engine's continuous collision follows
// (bodies/motion.h), and `torque_free`, the same small turns shortened in proportion. For bodies that spin about a
// principal axis they are equal; for others they part by centimetres within the step. Only what both agree on
// counts.
//
// The proof. Along any fixed direction n the gap of two convex solids is at most their distance. Between two times
// a point of a turning body moves along n by no more beyond its chord than (acceleration) (time)^2 / 8. So if the
// chord of the gap along n, less that, stays above a level, the distance does. Intervals are halved until this
// holds or they are too short to matter: a distance above the level is proved, not sampled.
#pragma once

#include "engine/bodies/body.h"
#include "tests/fuzz/solid_distance.h"

#include <array>
#include <optional>

namespace pushfactor::tests {

struct FreeBody {
    const Solid* solid = nullptr;
    engine::Body body;

    PlacedSolid placed() const { return {*solid, body.position, body.orientation}; }
    double reach() const { return solid->turning_radius + solid->radius; }  // m
};

enum class Turning { steady, torque_free };

// `body` `time` [s] after the start of a step of `dt`.
engine::Body moved(const engine::Body& body, double time, double dt, Turning turning);

// One step of a pair.
class PairStep {
  public:
    PairStep(const FreeBody& a, const FreeBody& b, double dt, Turning turning);

    PlacedSolid placed(int which, double time) const;
    Closeness at(double time) const;

    // s, the first time at which the distance is at most `level` [m], within 1e-9 m; none if it is proved to stay
    // above.
    std::optional<double> first_at(double level) const { return first_at(level, 0.0, dt_); }

  private:
    std::optional<double> first_at(double level, double from, double until) const;
    bool stays_above(double level, double from, double until) const;

    std::array<FreeBody, 2> bodies_;
    double dt_;
    Turning turning_;
    engine::Vector3 relative_velocity_;
    double bend_ = 0.0;   // m/s^2, most acceleration of a point of a, plus that of b
    double short_ = 0.0;  // s, in which the distance changes by less than 1e-9 m
};

// Overlaps and distances up to this are neither a touch nor a pass [m].
inline constexpr double graze = 1e-6;

struct Prediction {
    // A pair passes if its distance is above `graze` all the time. It touches if it is above it until the start of
    // one step, in which it overlaps by more.
    enum class Kind { passes, touches, unclear };

    Kind kind = Kind::unclear;
    long step = 0;                            // in which it touches, from 1 on
    double time = 0.0, gap = 0.0;             // s of the touch within the step, and m, distance at its start
    std::optional<engine::Vector3> normal{};  // from a to b; none where it is not unique
    bool in_margin = false;                   // the step starts closer than the engine's margin
    double next_gap = -engine::infinity;      // m at the touch, along the nearest other direction
    double turned = 0.0;                      // rad, by which the normal may differ at the start of that step
};

// The normal counts as unique if it turns by less than 1e-3 rad from a distance of 1e-5 of the smaller size on, if
// along all other faces and pairs of edges, farther than 1e-3 rad from it, the solids overlap by 1e-4 of that size,
// and if both motions agree on it to 1e-3 rad. What hits closer to an edge or a corner may take either of two
// faces.
Prediction predict(FreeBody a, FreeBody b, double dt, long steps);

// Whether the pair stays farther apart than `level` [m] during the run.
bool stays_above(double level, FreeBody a, FreeBody b, double dt, long steps, Turning turning);

}  // namespace pushfactor::tests
