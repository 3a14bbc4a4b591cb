// Contact manifold of two shapes, paper section 4 ("generate a contact manifold").
#pragma once

#include "engine/base/math.h"

#include <algorithm>
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
    static constexpr int most_points = 520;  // the corners of two faces of 256

    Vector3 normal = Vector3::UnitY();              // unit length, world frame, from shape a to shape b
    std::array<ContactPoint, most_points> storage;  // the first `count` are valid
    int count = 0;
    // m, a gap along the normal that certainly separates the shapes, also if there are no points; negative where
    // they overlap.
    double separation = infinity;
    // m, largest separation along an axis in another direction than the normal; -infinity if there is none or
    // if the overlap along all of them is deep.
    double other_gap = -infinity;

    // Whether the points are corners of a rounded surface, of which those farther out lie higher; otherwise they
    // are in one plane.
    bool rounded = false;

    // m, of its points and of `separation`.
    double smallest_gap() const {
        double gap = separation;
        for (const ContactPoint& point : points()) gap = std::min(gap, point.gap);
        return gap;
    }

    Manifold() {}  // NOLINT(modernize-use-equals-default): the points stay uninitialised
    void add(const ContactPoint& point) { storage[static_cast<std::size_t>(count++)] = point; }
    std::span<ContactPoint> points() & { return {storage.data(), static_cast<std::size_t>(count)}; }
    std::span<const ContactPoint> points() const& { return {storage.data(), static_cast<std::size_t>(count)}; }
    std::span<const ContactPoint> points() const&& = delete;  // would dangle
};

// How far the shapes of a manifold may turn on each other in the rest of the step, for the choice of its points.
struct Turning {
    std::span<const double> ends;  // m, gaps at the end of the step if the shapes moved freely; one per point
    double path = 0.0;             // m, of one surface towards the other
    double room = infinity;        // m, turned besides, because motion is not only what was before
    double allowed = infinity;     // m, by which a corner that is left out may sink
};

// Keeps the points that may carry the shapes: the deepest ones at the end of the step after a turn about any axis
// across the normal, of which the ends of a rounded manifold move by `path` and `room`. A corner between two that
// are kept sinks when the shapes roll from one to the other; so few directions of turning, from `least` to `most`,
// are tried as keep that `allowed`. They are fixed in `reference` (a rotation that moves with one of the shapes)
// and lie off the diagonals of a face, so that rounding does not choose between two points at one corner; for an
// elongated manifold they follow its long direction.
void keep_carrying(const Turning& turning, const Matrix3& reference, int least, int most, Manifold& manifold);

// A unit vector perpendicular to `normal`, fixed in the frame `reference`.
Vector3 tangent_fixed_in(const Matrix3& reference, const Vector3& normal);

}  // namespace pushfactor::engine::collision
