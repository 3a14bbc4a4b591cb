// Time of impact: when and where two moving shapes meet within a step.
//
// Conservative advancement (Mirtich 1996): shapes that are separated by a gap along a direction cannot meet
// before it can be closed, so time advances by the longest of these waits, repeatedly, until no gap is left.
// For shapes that do not turn each wait is exact. The direction of the last wait gives the contact normal: a
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

// Pose of the shape `time` [s] later.
Pose pose_at(const Moving& moving, double time);

// Upper bound on the approach of the shapes along `normal` (unit length, from a to b) in `time` [s] [m].
double approach(const Moving& a, const Moving& b, const Vector3& normal, double time);

struct Meeting {
    double time = 0.0;  // s, 0 for shapes that already touch
    Pose pose_a, pose_b;
    Manifold manifold;  // at that time
};

// Thresholds of a meeting [m].
struct Nearness {
    double tolerance = 0.0;  // distance at which they have met
    double margin = 0.0;     // closer points take part
    // Shapes that begin to overlap along two axes at once, e.g. when one grazes an edge of the other, meet only
    // when the overlap along all axes exceeds this (passing.h).
    double permitted = 0.0;
};

// Result of following a pair through the step.
struct Course {
    std::optional<Meeting> meeting;
    bool decided = true;  // false: no meeting found within the iteration limit, and none excluded
};

// First time within `dt` [s] at which the shapes meet. The manifold has all points that are closer than the
// margin then or may get so close in the rest of the step.
Course course_of(const Moving& a, const Moving& b, double dt, const Nearness& nearness);

inline std::optional<Meeting> find_meeting(const Moving& a, const Moving& b, double dt, double tolerance,
                                           double margin) {
    return course_of(a, b, dt, {.tolerance = tolerance, .margin = margin}).meeting;
}

}  // namespace pushfactor::engine::collision
