// The friction constraint, paper section 5.4: two rows per contact point, perpendicular to the normal, with v =
// 0, or with v = the speed of a belt, which is a motor in the sense of 8.1.
//
//   -c_min = c_max = mu m |g . n| / points
//
// Symbols: mu friction coefficient [1]; m combined mass of both bodies, or the mass of the movable one [kg];
// g gravity [m/s^2]; n contact normal; points: number of contact points of the pair.
//
// Deviations: the paper has g . n without the absolute value, which is negative when a is below b and would make
// c_max < c_min. Its bound is exact for one body on a static one and wrong in stacks, as the paper says itself. The
// alternative is Coulomb's law, mu times the normal force of the same point: either for each tangent alone, which
// turns the cone into a pyramid, or for the norm of both forces. A separated point carries no force unless it
// meets, which no weight can know: with the paper's bound its friction begins in the next step.
#pragma once

#include "engine/bodies/motion.h"
#include "engine/constraints/constraint_row.h"
#include "engine/constraints/point_jacobian.h"

#include <array>
#include <functional>

namespace pushfactor::engine {

// Inputs of a rule that bounds the friction between two bodies.
struct FrictionSite {
    const BodyPair& bodies;
    const Vector3& normal;      // unit length
    double friction = 0.0;      // mu
    int points = 1;             // contact points of the pair
    double size = 1.0;          // m, of the smaller movable body
    double acceleration = 0.0;  // m/s^2, from external forces, the larger of both bodies
    double dt = 1.0;            // s
};

// Bound for all contact points of a pair: a force [N], or a factor [1] of the force in the point's contact row.
struct FrictionBound {
    double limit = 0.0;
    bool of_normal_force = false;
    bool round = false;  // bounds the norm of both forces instead of each
    // m/s: slower sliding has no direction, so that rounding does not turn the tangents of a resting body. A disc
    // needs no direction, but the square around it, where exact solves begin, should be aligned with the sliding.
    double least_sliding = 0.0;

    // For the point whose contact row has index `normal_row` in the rows of the step, first or second tangent.
    Bounds at(int normal_row, Disc which) const {
        return {.c_min = -limit,
                .c_max = limit,
                .of_row = of_normal_force ? normal_row : -1,
                .disc = round ? which : Disc::none};
    }
};

// How friction is bounded.
using FrictionRule = std::function<FrictionBound(const FrictionSite&)>;

// The paper's bound, for gravity in m/s^2: constant, so the problem stays convex. The sliding threshold depends on
// the time step as well: 1e-4 of the size per step.
FrictionRule weight_friction(const Vector3& gravity);

// Coulomb's bound for each tangent: mu lambda of the point's contact row, in the same column. Along the
// diagonal of the tangents friction is up to sqrt(2) times too large. Sliding threshold: 1e-4 of sqrt(size *
// acceleration by external forces), the scale of the speed reached over the body's own size.
FrictionBound coulomb_friction(const FrictionSite& site);

// Coulomb's law: the same bound for the norm of both forces, a disc.
FrictionBound cone_friction(const FrictionSite& site);

// Relative motion of the surfaces of b and a, for all their contact points. World frame.
class RelativeMotion {
  public:
    // `belt` [m/s] is the surface velocity of a minus that of b; zero except for conveyors.
    RelativeMotion(const BodyPair& bodies, const Motion& a, const Motion& b, const Vector3& belt);

    // Sliding velocity across `normal` (unit length) at `point` [m]; m/s.
    Vector3 sliding(const Vector3& point, const Vector3& normal) const;

  private:
    Vector3 origin_;    // m, centre of a movable body, because rounding errors grow with the distance from it
    Vector3 velocity_;  // m/s, at the origin
    Vector3 spin_;      // rad/s
};

// Two orthogonal unit vectors perpendicular to `normal`. The first is along `sliding` if that exceeds
// `least_sliding` [m/s], otherwise `resting` (unit length, perpendicular to `normal`, fixed in one of the
// bodies, so that results rotate with the scene).
std::array<Vector3, 2> friction_tangents(const Vector3& normal, const Vector3& sliding, double least_sliding,
                                         const Vector3& resting);

// Writes one of the two rows into a default-constructed `row`. It aims at `speed` [m/s] of b relative to a
// along the tangent: zero, or the speed of a belt (8.1: "constant speed motors", a lasting push).
void write_friction_row(const PairPoint& point, const Vector3& tangent, const Bounds& bounds, double speed,
                        ConstraintRow& row);

}  // namespace pushfactor::engine
