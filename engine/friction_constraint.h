// The friction constraint, paper section 5.4: two rows a contact point, across the normal, with v = 0.
//
//   -c_min = c_max = mu m |g . n| / points
//
// Symbols: mu friction coefficient [1]; m combined mass of both bodies, or the mass of the movable one [kg];
// g gravity [m/s^2]; n contact normal; points: number of contact points of the pair.
//
// Deviations: the text has g . n without the absolute value, which is negative when a lies below b and would
// make c_max < c_min. Its bound is exact for one body on a static one and wrong in stacks, as the text says
// itself; Coulomb's law (mu times the normal force of the same point) stands beside it.
#pragma once

#include "engine/contact_constraint.h"

#include <array>

namespace pushfactor::engine {

// What a rule may look at to bound the friction at one contact point.
struct FrictionSite {
    const BodyPair& bodies;
    const Vector3& normal;  // unit length
    double friction = 0.0;  // mu
    int points = 1;         // contact points of the pair
    int normal_row = 0;     // index of the contact row of this point in the rows of the step
};

// How friction is bounded. A scene without friction has no rule.
class FrictionRule {
  public:
    virtual ~FrictionRule() = default;
    virtual Bounds bounds(const FrictionSite& site) const = 0;
};

// The paper's bound: a plain number, so the problem stays convex.
class WeightFriction : public FrictionRule {
  public:
    explicit WeightFriction(const Vector3& gravity) : gravity_(gravity) {}  // m/s^2
    Bounds bounds(const FrictionSite& site) const override;

  private:
    Vector3 gravity_;
};

// Coulomb's bound: mu lambda of the point's own contact row, in the same column.
class CoulombFriction : public FrictionRule {
  public:
    Bounds bounds(const FrictionSite& site) const override;
};

// Two unit vectors across `normal` and each other. The first lies along the sliding velocity at `point` [m] when
// that exceeds `least_sliding` [m/s], otherwise along a direction fixed in body a, so that results turn with the
// scene.
std::array<Vector3, 2> friction_tangents(const BodyPair& bodies, const Vector3& point, const Vector3& normal,
                                         double least_sliding);

ConstraintRow friction_row(const BodyPair& bodies, const Vector3& point, const Vector3& tangent,
                           const Bounds& bounds);

}  // namespace pushfactor::engine
