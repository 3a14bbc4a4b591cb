// The friction constraint, paper section 5.4: two rows a contact point, across the normal, with v = 0,
// or with v = the speed of a belt, which is a motor in the sense of 8.1.
//
//   -c_min = c_max = mu m |g . n| / points
//
// Symbols: mu friction coefficient [1]; m combined mass of both bodies, or the mass of the movable one [kg];
// g gravity [m/s^2]; n contact normal; points: number of contact points of the pair.
//
// Deviations: the text has g . n without the absolute value, which is negative when a lies below b and would
// make c_max < c_min. Its bound is exact for one body on a static one and wrong in stacks, as the text says
// itself; next to it there is Coulomb's law, mu times the normal force of the same point: for each tangent alone,
// which makes a square of the cone, or for the length of both forces. A point that is still apart carries nothing
// unless it meets, which no weight knows: with the paper's bound its friction begins in the step after.
#pragma once

#include "engine/bodies/motion.h"
#include "engine/constraints/constraint_row.h"
#include "engine/constraints/point_jacobian.h"

#include <array>

namespace pushfactor::engine {

// What a rule may look at to bound the friction between two bodies.
struct FrictionSite {
    const BodyPair& bodies;
    const Vector3& normal;      // unit length
    double friction = 0.0;      // mu
    int points = 1;             // contact points of the pair
    double size = 1.0;          // m, of the smaller movable body
    double acceleration = 0.0;  // m/s^2, by the external forces, the larger of both bodies
    double dt = 1.0;            // s
};

// A bound, the same for all contact points of a pair: a force [N], or a factor [1] of the force in the point's own
// contact row.
struct FrictionBound {
    double limit = 0.0;
    bool of_normal_force = false;
    bool round = false;  // of the length of both forces, not of each
    // m/s: slower sliding has no direction, so that a resting body does not turn its tangents with roundings. A
    // disc needs none, but the square around it, where exact solves begin, should lie along the sliding.
    double least_sliding = 0.0;

    // At a point whose contact row has this index in the rows of the step, for the first or second tangent.
    Bounds at(int normal_row, Disc which) const {
        return {.c_min = -limit,
                .c_max = limit,
                .of_row = of_normal_force ? normal_row : -1,
                .disc = round ? which : Disc::none};
    }
};

// How friction is bounded. A scene without friction has no rule.
class FrictionRule {
  public:
    virtual ~FrictionRule() = default;
    virtual FrictionBound bound(const FrictionSite& site) const = 0;
};

// The paper's bound: a plain number, so the problem stays convex. Like it, what counts as sliding depends on the
// step: a point that goes 1e-4 of the size in one.
class WeightFriction : public FrictionRule {
  public:
    explicit WeightFriction(const Vector3& gravity) : gravity_(gravity) {}  // m/s^2
    FrictionBound bound(const FrictionSite& site) const override;

  private:
    Vector3 gravity_;
};

// Coulomb's bound for each tangent: mu lambda of the point's own contact row, in the same column. Along the
// diagonal of the tangents friction is up to sqrt(2) times as large as it should be. What counts as sliding: 1e-4
// of sqrt(size * acceleration by the external forces), the speed that they give a body over its own size.
class CoulombFriction : public FrictionRule {
  public:
    FrictionBound bound(const FrictionSite& site) const override;
};

// Coulomb's law: the same bound for the length of both forces, a disc.
class ConeFriction : public FrictionRule {
  public:
    FrictionBound bound(const FrictionSite& site) const override;
};

// How the surface of body b runs over that of body a, for all points at which they touch. World frame.
class RelativeMotion {
  public:
    // `belt` [m/s] is how much faster the surface of a runs than that of b by itself; zero but for conveyors.
    RelativeMotion(const BodyPair& bodies, const Motion& a, const Motion& b, const Vector3& belt);

    // Across `normal` (unit length) at `point` [m]; m/s.
    Vector3 sliding(const Vector3& point, const Vector3& normal) const;

  private:
    Vector3 origin_;    // m, a body that moves: far from it roundings would grow
    Vector3 velocity_;  // m/s, at the origin
    Vector3 spin_;      // rad/s
};

// Two unit vectors across `normal` and each other. The first lies along `sliding` when that exceeds `least_sliding`
// [m/s], otherwise along `resting` (of unit length across `normal`, fixed in one of the bodies, so that results
// turn with the scene).
std::array<Vector3, 2> friction_tangents(const Vector3& normal, const Vector3& sliding, double least_sliding,
                                         const Vector3& resting);

// Writes one of the two rows into `row`, which is as it was made: it aims at `speed` [m/s] of b over a along the
// tangent, zero or what a belt runs (8.1: "constant speed motors", a push that lasts).
void write_friction_row(const PairPoint& point, const Vector3& tangent, const Bounds& bounds, double speed,
                        ConstraintRow& row);

}  // namespace pushfactor::engine
