#include "demos/scenes/convex_hull.h"

#include "engine/bodies/body.h"
#include "engine/collision/polyhedron.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>

namespace pushfactor::demos {

namespace {

using engine::Vector3;
using Triangle = std::array<int, 3>;

constexpr double thin = 1e-4;           // of the length: what is thinner counts as flat
constexpr double in_one_plane = 1e-5;   // of the length: how far corners of a face may be beside its plane
constexpr double plane_of_thin = 1e-3;  // of the thickness: the same

const Vector3& at(std::span<const Vector3> points, int index) {
    return points[static_cast<std::size_t>(index)];
}

struct Extent {
    std::array<int, 4> corners{};  // far points that span a tetrahedron
    double length = 0.0;           // m, from the first to the farthest
    double thickness = 0.0;        // m, the largest distance from the plane through the first three
};

// The number of the farthest of the points by `distance`, and its distance.
template <typename Distance>
std::pair<int, double> farthest(std::span<const Vector3> points, const Distance& distance) {
    std::pair<int, double> best{0, -1.0};
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double here = distance(points[i]);
        if (here > best.second) best = {static_cast<int>(i), here};
    }
    return best;
}

Extent extent_of(std::span<const Vector3> points) {
    if (points.size() < 4) throw NoPolyhedron(fmt::format("{} points", points.size()), "4 points or more");
    for (const Vector3& point : points) {
        if (!point.allFinite()) throw NoPolyhedron("points that are not finite", "finite points");
    }
    const int first = farthest(points, [&](const Vector3& p) { return (p - points.front()).norm(); }).first;
    const Vector3 from = at(points, first);
    const auto [second, length] = farthest(points, [&](const Vector3& p) { return (p - from).norm(); });
    if (!(length > 0.0)) throw NoPolyhedron("points in one place", "points with a volume");
    if (!(length >= engine::least_length && length <= engine::greatest_length)) {
        throw NoPolyhedron(
            fmt::format("length {:.3g} m", length),
            fmt::format("length from {:.3g} to {:.3g} m", engine::least_length, engine::greatest_length));
    }
    const auto scaled = [&, size = length](const Vector3& p) -> Vector3 { return (p - from) / size; };
    const Vector3 along = scaled(at(points, second));
    const auto [third, width] = farthest(points, [&](const Vector3& p) { return scaled(p).cross(along).norm(); });
    if (!(width > thin)) throw NoPolyhedron("points on a line", "points with a volume");
    const Vector3 normal = along.cross(scaled(at(points, third))).normalized();
    const auto [fourth, height] =
        farthest(points, [&](const Vector3& p) { return std::abs(normal.dot(scaled(p))); });
    if (!(height > thin)) throw NoPolyhedron("points in a plane", "points with a volume");
    return {{first, second, third, fourth}, length, height * length};
}

// Which side of a plane a point is on, exactly: the points are rounded to a grid, a length in 2^38 parts, and the
// determinants of their differences have at most 121 bits. So the hull is that of the rounded points, flat parts
// and all, and the same on every machine.
class Grid {
  public:
    Grid(std::span<const Vector3> points, const Extent& extent) {
        const Vector3 origin = at(points, extent.corners[0]);
        for (const Vector3& point : points) {
            const Vector3 scaled = (point - origin) / extent.length;
            Place place{};
            for (int axis = 0; axis < 3; ++axis) {
                place[static_cast<std::size_t>(axis)] =
                    static_cast<std::int64_t>(std::floor(scaled[axis] * 0x1p38));
            }
            places_.push_back(place);
        }
    }

    // Whether `point` is above the plane of a triangle, which is counter-clockwise seen from above.
    bool is_above(const Triangle& triangle, int point) const {
        const Place a = way(triangle[0], triangle[1]), b = way(triangle[0], triangle[2]),
                    c = way(triangle[0], point);
        return minor(a, b, 1, 2) * c[0] + minor(a, b, 2, 0) * c[1] + minor(a, b, 0, 1) * c[2] > 0;
    }

  private:
    using Place = std::array<std::int64_t, 3>;
    __extension__ using Wide = __int128;

    static Wide minor(const Place& a, const Place& b, std::size_t i, std::size_t j) {
        return Wide{a[i]} * b[j] - Wide{a[j]} * b[i];
    }
    Place way(int from, int to) const {
        const Place &a = places_[static_cast<std::size_t>(from)], &b = places_[static_cast<std::size_t>(to)];
        return {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    }

    std::vector<Place> places_;
};

// Triangles of the hull, counter-clockwise seen from outside. Grows point by point: the triangles that a point is
// above give way to those that join it to their outline.
std::vector<Triangle> triangulated_hull(std::span<const Vector3> points, const Extent& extent) {
    const Grid grid(points, extent);
    auto [a, b, c, d] = extent.corners;
    if (grid.is_above({a, b, c}, d)) std::swap(b, c);
    std::vector<Triangle> hull{{a, b, c}, {a, d, b}, {b, d, c}, {c, d, a}};
    std::set<std::pair<int, int>> edges;  // of the triangles that give way
    for (int point = 0; point < static_cast<int>(points.size()); ++point) {
        const auto kept = std::stable_partition(
            hull.begin(), hull.end(), [&](const Triangle& triangle) { return !grid.is_above(triangle, point); });
        edges.clear();
        for (auto triangle = kept; triangle != hull.end(); ++triangle) {
            for (std::size_t k = 0; k < 3; ++k) edges.emplace((*triangle)[k], (*triangle)[(k + 1) % 3]);
        }
        hull.erase(kept, hull.end());
        for (const auto& [from, to] : edges) {
            if (!edges.contains({to, from})) hull.push_back({from, to, point});
        }
    }
    return hull;
}

// Triangles by their edges, which go counter-clockwise about them.
using Edges = std::map<std::pair<int, int>, std::size_t>;

Edges edges_of(const std::vector<Triangle>& triangles) {
    Edges edges;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) edges[{triangles[t][k], triangles[t][(k + 1) % 3]}] = t;
    }
    return edges;
}

// Numbers the faces: triangles that lie in one plane have the same. Large ones decide first where a plane lies.
std::vector<int> merge(std::span<const Vector3> points, const std::vector<Triangle>& triangles, const Edges& edges,
                       double tolerance) {
    const auto normal = [&](std::size_t t) -> Vector3 {
        const auto& [a, b, c] = triangles[t];
        return (at(points, b) - at(points, a)).cross(at(points, c) - at(points, a));
    };
    std::vector<double> areas(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) areas[t] = normal(t).norm();
    std::vector<std::size_t> order(triangles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t p, std::size_t q) { return areas[p] > areas[q]; });

    std::vector<int> face(triangles.size(), -1);
    int count = 0;
    for (const std::size_t seed : order) {
        if (face[seed] >= 0) continue;
        const Vector3 up = normal(seed).normalized();
        const Vector3 on = at(points, triangles[seed][0]);
        const auto lies_in_plane = [&](std::size_t t) {
            return std::all_of(triangles[t].begin(), triangles[t].end(),
                               [&](int corner) { return std::abs(up.dot(at(points, corner) - on)) <= tolerance; });
        };
        face[seed] = count;
        std::vector<std::size_t> open{seed};
        while (!open.empty()) {
            const Triangle& triangle = triangles[open.back()];
            open.pop_back();
            for (std::size_t k = 0; k < 3; ++k) {
                const auto beside = edges.find({triangle[(k + 1) % 3], triangle[k]});
                if (beside == edges.end() || face[beside->second] >= 0 || !lies_in_plane(beside->second)) continue;
                face[beside->second] = count;
                open.push_back(beside->second);
            }
        }
        ++count;
    }
    return face;
}

// The outline of each face; `face`: by triangle.
std::vector<std::vector<int>> outlines(const Edges& edges, const std::vector<int>& face) {
    std::map<int, std::map<int, int>> next;  // by face: the corner after a corner
    std::map<int, std::set<int>> faces_of;   // by corner
    for (const auto& [edge, triangle] : edges) {
        const int here = face[triangle];
        const auto beyond = edges.find({edge.second, edge.first});
        if (beyond != edges.end() && face[beyond->second] == here) continue;
        next[here][edge.first] = edge.second;
        faces_of[edge.first].insert(here);
    }
    std::vector<std::vector<int>> loops;
    for (const auto& [number, corners] : next) {
        std::vector<int> loop;
        int corner = corners.begin()->first;
        for (std::size_t i = 0; i < corners.size() && corners.contains(corner); ++i) {
            if (faces_of[corner].size() >= 3) loop.push_back(corner);
            corner = corners.at(corner);
        }
        if (loop.size() >= 3) loops.push_back(loop);
    }
    return loops;
}

}  // namespace

ConvexHull convex_hull(std::span<const Vector3> points) {
    const Extent extent = extent_of(points);
    const double tolerance = std::min(in_one_plane * extent.length, plane_of_thin * extent.thickness);
    const std::vector<Triangle> triangles = triangulated_hull(points, extent);
    ConvexHull hull;
    const Edges edges = edges_of(triangles);
    hull.faces = outlines(edges, merge(points, triangles, edges, tolerance));

    std::map<int, int> number;  // of a corner in the hull
    for (const std::vector<int>& face : hull.faces) {
        for (const int corner : face) number[corner] = 0;
    }
    if (number.size() > engine::collision::most_vertices) {
        throw NoPolyhedron(fmt::format("{} corners", number.size()),
                           fmt::format("at most {} corners", engine::collision::most_vertices));
    }
    for (auto& [corner, index] : number) {
        index = static_cast<int>(hull.points.size());
        hull.points.push_back(at(points, corner));
    }
    for (std::vector<int>& face : hull.faces) {
        for (int& corner : face) corner = number[corner];
    }
    return hull;
}

}  // namespace pushfactor::demos
