// Polyhedra of a scene: the hull of points, as the engine wants it.
#pragma once

#include "engine/base/math.h"

#include <algorithm>
#include <memory>
#include <span>

namespace pushfactor::engine::collision {
class PolyhedronMesh;
}

namespace pushfactor::demos {

// Corners and faces in the body frame: the origin is the centre of mass, the axes are principal axes.
struct PolyhedronShape {
    std::shared_ptr<const engine::collision::PolyhedronMesh> mesh{};  // not null
    engine::Vector3 moments = engine::Vector3::Ones();                // m^2, principal moments per unit of mass
    double volume = 0.0;                                              // m^3

    std::span<const engine::Vector3> points() const;  // m
    double radius() const;                            // m, of the farthest corner

    bool operator==(const PolyhedronShape& other) const { return std::ranges::equal(points(), other.points()); }
};

// A shape, and where its body frame is in the frame of the points that it was made of.
struct FramedPolyhedron {
    PolyhedronShape shape{};
    engine::Vector3 centre = engine::Vector3::Zero();          // m, of mass
    engine::Quaternion axes = engine::Quaternion::Identity();  // body frame to frame of the points

    engine::Vector3 to_body(const engine::Vector3& point) const { return axes.conjugate() * (point - centre); }
};

// The convex hull of `points` [m]. Of the points of a shape it is this shape, bit for bit, with the frame where it
// is. Throws NoPolyhedron as convex_hull() does.
FramedPolyhedron make_polyhedron(std::span<const engine::Vector3> points);

}  // namespace pushfactor::demos
