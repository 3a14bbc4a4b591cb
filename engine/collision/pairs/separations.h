// Directions along which two shapes can be separated: the separating axes of paper section 4.
#pragma once

#include "engine/collision/collider.h"

#include <array>
#include <span>

namespace pushfactor::engine::collision {

// A direction and the gap along it.
struct Separation {
    Vector3 normal;    // unit length, from a to b
    double gap = 0.0;  // m, negative while they overlap along it
    int of_a = -1;     // face axis or edge direction of a, 0..2; -1 for a face axis of b
    int of_b = -1;     // the same for b
};

class Separations {
  public:
    // The six face axes of two boxes and the nine cross products of their edges, except those of parallel edges.
    Separations(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b);

    std::span<const Separation> all() const& { return {storage_.data(), static_cast<std::size_t>(count_)}; }
    std::span<const Separation> all() const&& = delete;  // would dangle

  private:
    void add(const Separation& separation) { storage_[static_cast<std::size_t>(count_++)] = separation; }

    std::array<Separation, 15> storage_;
    int count_ = 0;
};

// Sine of the angle below which two edges count as parallel. A face axis separates such boxes as well, up to
// this times the length of the edges.
inline constexpr double parallel_edges = 1e-6;

}  // namespace pushfactor::engine::collision
