// When two bodies that fly hit each other next.
#pragma once

#include "engine/collision/detector.h"
#include "engine/impacts/flight.h"

namespace pushfactor::engine {

// A collider on its way.
struct Flier {
    const collision::Shape& shape;
    const Flight& flight;
    double radius;   // m, of its farthest point from the centre; infinite for a plane
    double turning;  // m, the same of what turning moves: 0 for a ball
};

// Share of the speeds of both bodies that is an approach and not rounding.
inline constexpr double rounding_of_speeds = 1e-10;

// What counts as an impact of a pair: approach at more than the speed that its weight gives it in a step, and that
// it would not lift it by what counts as touching. Anything slower is left to the rows of the step, so that what
// lies at rest rests.
struct ImpactLimits {
    double size = 0.0;      // m, of the pair
    double touching = 0.0;  // m, gap up to which it touches (contact_row.h)
    double dt = 0.0;        // s, of the step
    double least = 0.0;     // m/s, whatever the bodies weigh

    // m/s along `normal`, for bodies that fall with these accelerations [m/s^2].
    double least_speed(const Vector3& normal, const Vector3& fall_a, const Vector3& fall_b) const;
};

struct NextImpact {
    double time = never;  // s, in the step
    double speed = 0.0;   // m/s, of the approach
};

// The first one from `from` [s] on, within the step, at which the pair touches and approaches faster than the
// limits say; `never` if there is none. `manifold` receives the points that touch then.
NextImpact next_impact(const Flier& a, const Flier& b, const ImpactLimits& limits, double from,
                       collision::Manifold& manifold);

}  // namespace pushfactor::engine
