#include "demos/scenes/convex_hull.h"

#include "engine/bodies/body.h"
#include "engine/collision/polyhedron.h"

#include <fmt/format.h>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
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
    Vector3 origin;          // m, one of the points
    double length = 0.0;     // m, from it to the farthest
    double thickness = 0.0;  // m, the largest distance from a plane through three far points
};

// The farthest of the points by `distance`, with it.
template <typename Distance>
std::pair<Vector3, double> farthest(std::span<const Vector3> points, const Distance& distance) {
    std::pair<Vector3, double> best{points.front(), -1.0};
    for (const Vector3& point : points) {
        const double here = distance(point);
        if (here > best.second) best = {point, here};
    }
    return best;
}

Extent extent_of(std::span<const Vector3> points) {
    if (points.size() < 4) throw NoPolyhedron(fmt::format("{} points", points.size()), "4 points or more");
    for (const Vector3& point : points) {
        if (!point.allFinite()) throw NoPolyhedron("points that are not finite", "finite points");
    }
    const Vector3 first = points.front();
    const auto [origin, any] = farthest(points, [&](const Vector3& p) { return (p - first).norm(); });
    const Vector3 from = origin;
    const auto end_and_length = farthest(points, [&](const Vector3& p) { return (p - from).norm(); });
    const Vector3 end = end_and_length.first;
    const double length = end_and_length.second;
    if (!(length > 0.0)) throw NoPolyhedron("points in one place", "points with a volume");
    if (!(length >= engine::least_length && length <= engine::greatest_length)) {
        throw NoPolyhedron(
            fmt::format("length {:.3g} m", length),
            fmt::format("length from {:.3g} to {:.3g} m", engine::least_length, engine::greatest_length));
    }
    const Vector3 along = (end - from) / length;
    const auto [side, width] =
        farthest(points, [&](const Vector3& p) { return ((p - from) / length).cross(along).norm(); });
    if (!(width > thin)) throw NoPolyhedron("points on a line", "points with a volume");
    const Vector3 normal = along.cross((side - from) / length).normalized();
    const auto [top, height] =
        farthest(points, [&](const Vector3& p) { return std::abs(normal.dot((p - from) / length)); });
    if (!(height > thin)) throw NoPolyhedron("points in a plane", "points with a volume");
    return {from, length, height * length};
}

// One run of Qhull.
class Qhull {
  public:
    // `coordinates`: three numbers per point, which have to outlive this object.
    explicit Qhull(std::vector<double>& coordinates) : errors_(std::fopen("/dev/null", "w"), std::fclose) {
        qh_zero(&qhull_, errors_.get());
        std::array<char, 12> command{"qhull Qt Pp"};
        const auto count = static_cast<int>(coordinates.size() / 3);
        status_ =
            qh_new_qhull(&qhull_, 3, count, coordinates.data(), False, command.data(), nullptr, errors_.get());
    }
    Qhull(const Qhull&) = delete;
    Qhull& operator=(const Qhull&) = delete;
    ~Qhull() {
        qh_freeqhull(&qhull_, !qh_ALL);
        int blocks = 0, bytes = 0;
        qh_memfreeshort(&qhull_, &blocks, &bytes);
    }

    bool has_hull() const { return status_ == 0; }

    // All turned alike.
    std::vector<Triangle> triangles() {
        std::vector<Triangle> all;
        qhT* const qh = &qhull_;  // the macros want this name
        facetT* facet = nullptr;
        FORALLfacets {
            Triangle triangle{};
            std::size_t count = 0;
            vertexT *vertex = nullptr, **vertexp = nullptr;
            FOREACHvertex_(facet->vertices) {
                if (count < 3) triangle[count++] = qh_pointid(qh, vertex->point);
            }
            if ((facet->toporient != 0) != (qh_ORIENTclock != 0)) std::swap(triangle[0], triangle[1]);
            all.push_back(triangle);
        }
        return all;
    }

  private:
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> errors_;
    qhT qhull_{};
    int status_ = 0;
};

// Triangles of the hull, counter-clockwise seen from outside.
std::vector<Triangle> triangulated_hull(std::span<const Vector3> points, const Extent& extent) {
    std::vector<double> coordinates;
    coordinates.reserve(3 * points.size());
    for (const Vector3& point : points) {
        const Vector3 scaled = (point - extent.origin) / extent.length;
        coordinates.insert(coordinates.end(), {scaled.x(), scaled.y(), scaled.z()});
    }
    Qhull qhull(coordinates);
    if (!qhull.has_hull()) throw NoPolyhedron("points without a hull", "points with a volume");
    std::vector<Triangle> triangles = qhull.triangles();
    double volume = 0.0;
    for (const auto& [a, b, c] : triangles) {
        const auto scaled = [&](int index) { return Vector3((at(points, index) - extent.origin) / extent.length); };
        volume += scaled(a).dot(scaled(b).cross(scaled(c)));
    }
    if (volume < 0.0) {
        for (Triangle& triangle : triangles) std::swap(triangle[0], triangle[1]);
    }
    return triangles;
}

// Numbers the faces: triangles that lie in one plane have the same. Large ones decide first where a plane lies.
std::vector<int> merge(std::span<const Vector3> points, const std::vector<Triangle>& triangles, double tolerance) {
    std::map<std::pair<int, int>, std::size_t> by_edge;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) by_edge[{triangles[t][k], triangles[t][(k + 1) % 3]}] = t;
    }
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
                const auto beside = by_edge.find({triangle[(k + 1) % 3], triangle[k]});
                if (beside == by_edge.end() || face[beside->second] >= 0 || !lies_in_plane(beside->second))
                    continue;
                face[beside->second] = count;
                open.push_back(beside->second);
            }
        }
        ++count;
    }
    return face;
}

// The outline of each face.
std::vector<std::vector<int>> outlines(const std::vector<Triangle>& triangles, const std::vector<int>& face) {
    const auto count = static_cast<std::size_t>(*std::max_element(face.begin(), face.end()) + 1);
    std::vector<std::map<int, int>> next(count);  // by face: the corner after a corner
    std::map<std::pair<int, int>, int> face_at;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) face_at[{triangles[t][k], triangles[t][(k + 1) % 3]}] = face[t];
    }
    std::map<int, std::set<int>> faces_of;  // by corner
    for (const auto& [edge, here] : face_at) {
        const auto beyond = face_at.find({edge.second, edge.first});
        if (beyond != face_at.end() && beyond->second == here) continue;
        next[static_cast<std::size_t>(here)][edge.first] = edge.second;
        faces_of[edge.first].insert(here);
    }
    std::vector<std::vector<int>> loops;
    for (const std::map<int, int>& corners : next) {
        if (corners.empty()) continue;
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
    hull.faces = outlines(triangles, merge(points, triangles, tolerance));

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
