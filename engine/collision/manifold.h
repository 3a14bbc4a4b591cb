// Where two shapes touch, paper section 4 ("generate a contact manifold").
#pragma once

#include "engine/base/math.h"

#include <array>
#include <cstdint>
#include <limits>
#include <span>

namespace pushfactor::engine::collision {

struct ContactPoint {
    Vector3 position;       // m, world frame, midway between the two surfaces
    double gap;             // m along the normal; below zero is penetration (d = -gap)
    std::uint32_t feature;  // names the faces, edges or vertices that made the point, from step to step
};

struct Manifold {
    static constexpr int max_points = 8;  // two quadrilaterals meet in an octagon at most

    Vector3 normal = Vector3::UnitY();             // unit length, world frame, from shape a to shape b
    std::array<ContactPoint, max_points> storage;  // of which `count` are there
    int count = 0;
    // m, the largest separation along an axis in another direction than the normal; -infinity where there is none
    // or where the overlap along all of them is deep.
    double other_gap = -std::numeric_limits<double>::infinity();

    // m, the separation of two boxes along the normal, which is less than the gap of their points where these do
    // not face each other; infinity for other shapes, and for boxes that are farther apart than the margin.
    double separation = std::numeric_limits<double>::infinity();

    void add(const ContactPoint& point) { storage[static_cast<std::size_t>(count++)] = point; }
    std::span<const ContactPoint> points() const& { return {storage.data(), static_cast<std::size_t>(count)}; }
    std::span<const ContactPoint> points() const&& = delete;  // they end with the object
};

// Keeps at most four points: the outermost in four directions of the contact plane, deeper ones preferred. The
// directions hang on `reference` (a rotation that moves with one of the shapes) and lie off the diagonals of a
// face, so that rounding does not choose between two points of one corner; where the points span much more one way
// than the other, the directions follow that span. Does nothing to four or fewer.
void reduce_to_four(Manifold& manifold, const Matrix3& reference);

// A unit vector across `normal` that is fixed in the frame `reference`.
Vector3 tangent_fixed_in(const Matrix3& reference, const Vector3& normal);

}  // namespace pushfactor::engine::collision
