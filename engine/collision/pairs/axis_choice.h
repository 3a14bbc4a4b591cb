// The choice among the separating axes of two polyhedra. The paper (section 4) leaves it open:
// - among the axes of one polyhedron that tie up to rounding, as in every row of touching boxes, the first one is
//   taken;
// - the reference face is a's unless b's separates clearly better, and an edge pair has to be clearly better
//   than both: a choice that rounding could flip would change the features and lose the cached forces.
#pragma once

#include "engine/base/math.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine::collision {

// Difference up to which axes are equal, of which the first one wins; a fraction of the smaller polyhedron's least
// width.
inline constexpr double axis_rounding = 1e-6;

// The best axis of each of the three groups. An Axis has a `gap` [m], negative while the polyhedra overlap along
// it.
template <typename Axis>
struct BestAxes {
    Axis face_a, face_b, edges;

    double largest_face() const { return std::max(face_a.gap, face_b.gap); }
    double largest() const { return std::max(largest_face(), edges.gap); }

    // The one to take if it is better than those before it by more than `preference` [m].
    const Axis& preferred(double preference) const {
        if (edges.gap > largest_face() + preference) return edges;
        return face_b.gap > face_a.gap + preference ? face_b : face_a;
    }
};

// Cosine above which two directions belong to one face or edge.
inline constexpr double same_direction = 0.9;

// Cosine above which two directions are equal up to rounding and the tilt that an overlap makes.
inline constexpr double same_axis = 0.999;

// The largest gap along a face axis other than `normal`, of those that overlap by no more than `much` [m].
class GapOfOthers {
  public:
    GapOfOthers(const Vector3& normal, double much) : normal_(normal), much_(much) {}

    template <typename Direction>
    void consider(double gap, const Direction& axis) {
        if (gap < -much_ || gap <= largest_) return;
        if (std::abs(axis.dot(normal_)) < same_direction) largest_ = gap;
    }
    double largest() const { return largest_; }

  private:
    const Vector3& normal_;
    double much_;
    double largest_ = -infinity;
};

}  // namespace pushfactor::engine::collision
