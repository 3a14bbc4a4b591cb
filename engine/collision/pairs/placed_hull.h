// Shapes with flat faces at their place, as the pairs of polyhedra see them.
#pragma once

#include "engine/collision/collider.h"

#include <array>
#include <concepts>

namespace pushfactor::engine::collision {

template <typename T>
concept Flat = std::same_as<T, Box> || std::same_as<T, Polyhedron>;

// A polyhedron, or a box as one. Refers to the shape and the pose.
class PlacedHull {
  public:
    PlacedHull(const Polyhedron& polyhedron, const Pose& pose) : hull_(&polyhedron.mesh->hull()), pose_(pose) {}
    PlacedHull(const Box& box, const Pose& pose);
    PlacedHull(const PlacedHull&) = delete;
    PlacedHull& operator=(const PlacedHull&) = delete;

    const Hull& hull() const { return *hull_; }
    const Pose& pose() const { return pose_; }

  private:
    const Hull* hull_;
    const Pose& pose_;
    // Of a box.
    std::array<Vector3, 8> vertices_;
    std::array<HullFace, 6> faces_;
    std::array<HullEdge, 12> edges_;
    Hull box_;
};

}  // namespace pushfactor::engine::collision
