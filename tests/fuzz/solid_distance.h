// Exact distances of two convex solids by looking at all their features: the measure by which collisions are
// judged, independent of the engine's collision code.
//
// The signed distance of convex solids is the largest gap between them along any direction. For polyhedra that
// overlap it belongs to a face or to two edges, and all of them are tried; for those that do not it is the distance
// of two closest features, and all pairs are tried. A ball is a point with a radius.
#pragma once

#include "demos/scenes/scene_description.h"

#include <array>
#include <utility>
#include <vector>

namespace pushfactor::tests {

// A convex polyhedron, or a point, grown by `radius`.
struct Solid {
    struct Face {
        engine::Vector3 normal;    // unit length, outward
        std::vector<int> corners;  // a loop, counter-clockwise seen from outside
    };

    std::vector<engine::Vector3> points;  // m, body frame
    std::vector<Face> faces;
    std::vector<std::pair<int, int>> edges;  // of a point one, without length
    double radius = 0.0;                     // m
    double turning_radius = 0.0;             // m, of the farthest of `points`
    double size = 0.0;                       // m, the least width across a face, or the diameter
};

Solid solid_of(const demos::BodyDescription& body);  // a box, a ball or a polyhedron

// A solid somewhere in the world.
struct PlacedSolid {
    PlacedSolid(const Solid& solid, const engine::Vector3& position, const engine::Quaternion& orientation);

    const Solid* solid;
    engine::Vector3 position;             // m
    std::vector<engine::Vector3> points;  // m, world frame
    std::vector<engine::Vector3> normals;
};

// m, gap between the solids along the unit vector `normal`; negative where they overlap along it.
double gap_along(const PlacedSolid& a, const PlacedSolid& b, const engine::Vector3& normal);

struct Closeness {
    double distance = 0.0;   // m; negative: how deep they overlap
    engine::Vector3 normal;  // unit length, from a to b: the direction with that gap
};

Closeness closeness(const PlacedSolid& a, const PlacedSolid& b);

// Closest points of two solids that do not overlap, without their radii [m].
std::pair<engine::Vector3, engine::Vector3> closest_points(const PlacedSolid& a, const PlacedSolid& b);

// m, the largest gap of overlapping polyhedra along a face or two edges whose direction is farther than `angle`
// [rad] from `normal`; minus infinity if one is a ball, whose normals are unique.
double next_gap(const PlacedSolid& a, const PlacedSolid& b, const engine::Vector3& normal, double angle);

}  // namespace pushfactor::tests
