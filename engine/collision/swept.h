// When and where two moving shapes meet within a step.
//
// Conservative advancement (Mirtich 1996): along a direction in which the shapes are apart by a gap they cannot
// meet before that gap can be closed, so time goes on by the longest of these waits, again and again, until no gap
// is left. For shapes that do not turn every wait is exact. What ends the last wait gives the contact its normal: a
// body that passes an edge is never stopped by the plane of a face that it does not meet.
#pragma once

#include "engine/collision/collider.h"
#include "engine/collision/manifold.h"
#include "engine/motion.h"

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

// The first moment within `dt` [s] when the shapes come closer than `tolerance` [m]; nothing when they do not, or
// not within a hundred waits. The manifold has all points that are closer than `margin` [m] then or may come as
// close in the rest of the step.
std::optional<Meeting> find_meeting(const Moving& a, const Moving& b, double dt, double tolerance, double margin);

}  // namespace pushfactor::engine::collision
