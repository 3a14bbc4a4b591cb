// When and where two moving shapes meet within a step.
//
// Conservative advancement (Mirtich 1996): along a direction in which the shapes are apart by a gap they cannot
// meet before that gap can be closed, so time goes on by the longest of these waits, again and again, until no gap
// is left. For shapes that do not turn every wait is exact. What ends the last wait gives the contact its normal: a
// body that passes an edge is never stopped by the plane of a face that it does not meet.
#pragma once

#include "engine/bodies/motion.h"
#include "engine/collision/collider.h"
#include "engine/collision/manifold.h"

#include <optional>

namespace pushfactor::engine::collision {

struct Moving {
    const Shape& shape;
    Pose start;
    Motion motion;
};

// Where the shape is `time` [s] later.
Pose pose_at(const Moving& moving, double time);

// How far at most the shapes come towards each other along `normal` (unit length, from a to b) in `time` [s] [m].
double approach(const Moving& a, const Moving& b, const Vector3& normal, double time);

struct Meeting {
    double time = 0.0;  // s, 0 for shapes that touch already
    Pose pose_a, pose_b;
    Manifold manifold;  // at that moment
};

// How near two shapes have to come to meet, and how far they may overlap [m].
struct Nearness {
    double tolerance = 0.0;  // closer than this they have met
    double margin = 0.0;     // points that are closer take part
    // Shapes that come to overlap along two axes at once, as at an edge that one of them grazes, only meet when the
    // overlap along all axes exceeds this (passing.h).
    double permitted = 0.0;
};

// How the pair comes through the step.
struct Course {
    std::optional<Meeting> meeting;
    bool decided = true;  // false: no meeting in as many waits as are allowed, and none excluded
};

// The first moment within `dt` [s] when the shapes meet. The manifold has all points that are closer than the
// margin then or may come as close in the rest of the step.
Course follow(const Moving& a, const Moving& b, double dt, const Nearness& nearness);

inline std::optional<Meeting> find_meeting(const Moving& a, const Moving& b, double dt, double tolerance,
                                           double margin) {
    return follow(a, b, dt, {.tolerance = tolerance, .margin = margin}).meeting;
}

}  // namespace pushfactor::engine::collision
