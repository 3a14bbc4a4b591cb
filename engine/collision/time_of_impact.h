// Time of impact: when two moving shapes meet within a step.
//
// Conservative advancement (Mirtich 1996): shapes that are separated by a gap along a direction cannot meet before
// it can be closed, so time advances by the longest of these waits, repeatedly, until no gap is left. For shapes
// that do not turn each wait is exact.
#pragma once

#include "engine/bodies/motion.h"
#include "engine/collision/collider.h"

namespace pushfactor::engine::collision {

struct Moving {
    const Shape& shape;
    Pose start;
    Motion motion;
};

// Pose of the shape `time` [s] later.
Pose pose_at(const Moving& moving, double time);

// The gap along `normal` (unit length, from a to b) at the start [m]; negative if they overlap along it. A plane is
// only separated along its own normal.
double gap_along(const Moving& a, const Moving& b, const Vector3& normal);

// Upper bound on the approach of the shapes along `normal` (unit length, from a to b) in `time` [s] [m].
double approach(const Moving& a, const Moving& b, const Vector3& normal, double time);

// Result of following a pair through a step.
struct Course {
    double time = never;  // s, when the shapes meet; `never` if they pass
    bool decided = true;  // false: neither found nor excluded within the limit of iterations
};

// The first time within `dt` [s] at which the shapes are closer than `tolerance` [m] and have contact points.
Course course_of(const Moving& a, const Moving& b, double dt, double tolerance);

}  // namespace pushfactor::engine::collision
