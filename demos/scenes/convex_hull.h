// The convex hull of points, the same on every machine.
#pragma once

#include "engine/base/invalid_input.h"
#include "engine/base/math.h"

#include <span>
#include <string>
#include <vector>

namespace pushfactor::demos {

// Points of which no polyhedron can be made.
class NoPolyhedron : public engine::InvalidInput {
  public:
    NoPolyhedron(const std::string& what_they_are, const std::string& what_is_allowed)
        : InvalidInput("polyhedron of", what_they_are, "of " + what_is_allowed),
          found(what_they_are),
          allowed(what_is_allowed) {}

    std::string found, allowed;
};

// A convex polyhedron.
struct ConvexHull {
    std::vector<engine::Vector3> points;  // the corners, in the order of the input
    std::vector<std::vector<int>> faces;  // loops of corners, counter-clockwise seen from outside
};

// Faces that lie in one plane are one face, up to 1e-5 of the size of the whole, as do numbers with six digits.
// Corners that this leaves within a face or an edge are dropped. Throws NoPolyhedron for points that are
// fewer than four, not finite, in one place, on a line or in a plane, and for a hull of more corners than a shape
// may have.
ConvexHull convex_hull(std::span<const engine::Vector3> points);

}  // namespace pushfactor::demos
