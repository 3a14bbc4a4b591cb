// Contact manifold of two shapes, paper section 4 ("generate a contact manifold").
#pragma once

#include "engine/base/math.h"

#include <array>
#include <cstdint>
#include <span>

namespace pushfactor::engine::collision {

struct ContactPoint {
    Vector3 position;       // m, world frame, midway between the two surfaces
    double gap;             // m along the normal; negative is penetration (d = -gap)
    std::uint32_t feature;  // identifies the faces, edges or vertices that made the point, across steps
};

struct Manifold {
    static constexpr int max_points = 8;  // as many as two quadrilaterals intersect in

    Vector3 normal = Vector3::UnitY();             // unit length, world frame, from shape a to shape b
    std::array<ContactPoint, max_points> storage;  // the first `count` are valid
    int count = 0;
    // m, largest separation along an axis in another direction than the normal; -infinity if there is none or
    // if the overlap along all of them is deep.
    double other_gap = -infinity;

    // m, separation of two boxes along the normal; smaller than the gap of their points if these do not face
    // each other. Infinity for other shapes and for boxes farther apart than the margin.
    double separation = infinity;

    // m; points higher than this above the deepest one are the last to be chosen. Finite where a rounded surface
    // lies on a plane: what is near and farther out does not support it.
    double layer = infinity;

    void add(const ContactPoint& point) { storage[static_cast<std::size_t>(count++)] = point; }
    std::span<const ContactPoint> points() const& { return {storage.data(), static_cast<std::size_t>(count)}; }
    std::span<const ContactPoint> points() const&& = delete;  // would dangle
};

// Adds `points` to an empty manifold, whose normal and layer are set: of more than eight those that are outermost
// in eight directions. `reference` as below.
void add_outermost(std::span<const ContactPoint> points, const Matrix3& reference, Manifold& manifold);

// Keeps at most four points: the outermost in four directions of the contact plane, preferring deep ones. The
// directions are fixed in `reference` (a rotation that moves with one of the shapes) and lie off the diagonals
// of a face, so that rounding does not choose between two points at one corner; for an elongated manifold they
// follow its long direction. Does nothing for four or fewer points.
void reduce_to_four(Manifold& manifold, const Matrix3& reference);

// A unit vector perpendicular to `normal`, fixed in the frame `reference`.
Vector3 tangent_fixed_in(const Matrix3& reference, const Vector3& normal);

}  // namespace pushfactor::engine::collision
