// Convex polyhedra for tests.
#pragma once

#include "demos/scenes/polyhedron_shape.h"
#include "engine/collision/collider.h"
#include "tests/random.h"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace pushfactor::tests {

using Points = std::vector<engine::Vector3>;

inline engine::collision::Polyhedron polyhedron_of(std::span<const engine::Vector3> points) {
    return {demos::make_polyhedron(points).shape.mesh};
}

// Corners of a box in the order in which plane_pairs.cpp numbers them.
inline Points box_points(const engine::Vector3& half_size) {
    Points points;
    for (unsigned k = 0; k < 8; ++k) {
        const engine::Vector3 sign((k & 1u) ? 1.0 : -1.0, (k & 2u) ? 1.0 : -1.0, (k & 4u) ? 1.0 : -1.0);
        points.push_back(sign.cwiseProduct(half_size));
    }
    return points;
}

// A regular polyhedron with its edge and, for edge length 1 and mass 1, its volume and its moment of inertia.
struct Platonic {
    const char* name;
    Points points;
    double edge;    // of the points
    double volume;  // for edge 1
    double moment;
    std::size_t faces;
};

inline std::vector<Platonic> platonic_solids() {
    using std::numbers::phi, std::sqrt;
    std::vector<Platonic> all;
    all.push_back(
        {"tetrahedron", {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, sqrt(8.0), sqrt(2.0) / 12, 0.05, 4});
    all.push_back({"cube", box_points({1, 1, 1}), 2, 1, 1.0 / 6, 6});
    Points octahedron, icosahedron, dodecahedron = box_points({1, 1, 1});
    for (const double s : {1.0, -1.0}) {
        for (int axis = 0; axis < 3; ++axis) {
            engine::Vector3 point = engine::Vector3::Zero();
            point[axis] = s;
            octahedron.push_back(point);
            for (const double t : {1.0, -1.0}) {
                engine::Vector3 a = engine::Vector3::Zero(), b = a;
                a[axis] = s, a[(axis + 1) % 3] = t * phi;
                b[axis] = s / phi, b[(axis + 1) % 3] = t * phi;
                icosahedron.push_back(a);
                dodecahedron.push_back(b);
            }
        }
    }
    all.push_back({"octahedron", octahedron, sqrt(2.0), sqrt(2.0) / 3, 0.1, 8});
    all.push_back({"dodecahedron", dodecahedron, 2 / phi, (15 + 7 * sqrt(5.0)) / 4, (39 * phi + 28) / 150, 12});
    all.push_back({"icosahedron", icosahedron, 2, 5 * (3 + sqrt(5.0)) / 12, phi * phi / 10, 20});
    return all;
}

// Points in a box of random edges, up to `most` of them: hulls from tetrahedra to many corners.
inline Points random_points(Random& random, int most = 24) {
    for (;;) {
        const engine::Vector3 reach = random.vector(0.3, 1.0);
        const int count = 4 + static_cast<int>(random.in(0, most - 3));
        Points points;
        for (int i = 0; i < count; ++i) points.emplace_back(random.vector(-1, 1).cwiseProduct(reach));
        const engine::Vector3 normal = (points[1] - points[0]).cross(points[2] - points[0]).normalized();
        for (const engine::Vector3& point : points) {
            if (std::abs(normal.dot(point - points[0])) > 0.01) return points;  // not in one plane
        }
    }
}

// Points on a sphere of radius 1, evenly: a spiral.
inline Points ball_points(int count) {
    Points points;
    for (int i = 0; i < count; ++i) {
        const double y = 1.0 - (2.0 * i + 1.0) / count, turn = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
        const double across = std::sqrt(1.0 - y * y);
        points.emplace_back(across * std::cos(turn), y, across * std::sin(turn));
    }
    return points;
}

}  // namespace pushfactor::tests
