#include "engine/collision/polyhedron.h"

#include "engine/base/invalid_input.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <tuple>

namespace pushfactor::engine::collision {

namespace {

constexpr double bent = 1e-4;  // of the size: how far a vertex may be beside the plane of its face

using Loop = std::vector<int>;

void require(bool condition, const std::string& what, const std::string& allowed) {
    if (!condition) throw InvalidInput("polyhedron with", what, allowed);
}

Vector3 normal_of(const Loop& loop, std::span<const Vector3> vertices) {
    const auto at = [&](std::size_t i) { return vertices[static_cast<std::size_t>(loop[i])]; };
    Vector3 normal = Vector3::Zero();
    for (std::size_t i = 2; i < loop.size(); ++i) normal += (at(i - 1) - at(0)).cross(at(i) - at(0));
    return normal.normalized();
}

// Directions that differ by rounding only are equal.
long rounded(double share) {
    return std::lround(share * 1e9);
}

// Whether the first component that is not zero is positive.
bool points_forward(const Vector3& normal) {
    for (const double component : normal) {
        if (rounded(component) != 0) return component > 0.0;
    }
    return true;
}

// Sorts directions: those along the axis `first` before those along the next ones, + before -.
auto order_of(const Vector3& direction, int first = 0) {
    const auto along = [&](int k) { return -rounded(direction[(first + k) % 3]); };
    return std::tuple(-std::abs(along(0)), -std::abs(along(1)), -std::abs(along(2)), along(0), along(1), along(2));
}

int main_axis(const Vector3& normal) {
    int axis = 0;
    for (const int other : {1, 2}) {
        if (std::abs(rounded(normal[other])) > std::abs(rounded(normal[axis]))) axis = other;
    }
    return axis;
}

// The sides of a face in the order in which they clip: numbers of the corners at which they begin.
std::vector<int> sides_of(const Loop& loop, const Vector3& normal, std::span<const Vector3> vertices) {
    const auto out = [&](int corner) -> Vector3 {
        const auto i = static_cast<std::size_t>(corner);
        const Vector3& from = vertices[static_cast<std::size_t>(loop[i])];
        const Vector3& to = vertices[static_cast<std::size_t>(loop[i + 1 < loop.size() ? i + 1 : 0])];
        return (to - from).cross(normal).normalized();
    };
    std::vector<int> sides(loop.size());
    std::iota(sides.begin(), sides.end(), 0);
    const int first = main_axis(normal) + 1;
    std::stable_sort(sides.begin(), sides.end(),
                     [&](int p, int q) { return order_of(out(p), first) < order_of(out(q), first); });
    return sides;
}

// Begins the loop with its vertex farthest along x, among equals along y, then z.
void begin_with_farthest(Loop& loop, std::span<const Vector3> vertices, double rounding) {
    const auto farther = [&](int p, int q) {
        const Vector3 offset = vertices[static_cast<std::size_t>(p)] - vertices[static_cast<std::size_t>(q)];
        for (const double component : offset) {
            if (std::abs(component) > rounding) return component > 0.0;
        }
        return false;
    };
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end(), farther), loop.end());
}

void require_loops(const std::vector<Loop>& loops, std::size_t vertices) {
    const std::string count = std::to_string(vertices) + " vertices";
    require(vertices >= least_vertices && vertices <= most_vertices, count,
            "4 to " + std::to_string(most_vertices) + " vertices");
    require(loops.size() >= 4, std::to_string(loops.size()) + " faces", "4 faces or more");
    for (const Loop& loop : loops) {
        require(loop.size() >= 3, "a face of " + std::to_string(loop.size()) + " corners", "3 corners or more");
        for (const int index : loop) {
            require(index >= 0 && static_cast<std::size_t>(index) < vertices, "vertex " + std::to_string(index),
                    "among its " + count);
        }
    }
}

}  // namespace

double support(const Hull& hull, const Vector3& direction) {
    double most = -infinity;
    for (const Vector3& vertex : hull.vertices) {
        const double along = direction[0] * vertex[0] + direction[1] * vertex[1] + direction[2] * vertex[2];
        if (along > most) most = along;
    }
    return most;
}

PolyhedronMesh::PolyhedronMesh(std::vector<Vector3> vertices, const std::vector<std::vector<int>>& faces)
    : vertices_(std::move(vertices)) {
    require_loops(faces, vertices_.size());
    for (const Vector3& vertex : vertices_) {
        require(vertex.allFinite(), "a vertex that is not finite", "finite vertices");
        squared_radius_ = std::max(squared_radius_, vertex.squaredNorm());
    }

    struct Sorted {
        Vector3 normal;
        Loop loop;
    };
    std::vector<Sorted> sorted;
    for (const Loop& loop : faces) {
        sorted.push_back({normal_of(loop, vertices_), loop});
        begin_with_farthest(sorted.back().loop, vertices_, 1e-9 * std::sqrt(squared_radius_));
    }
    std::sort(sorted.begin(), sorted.end(), [](const Sorted& a, const Sorted& b) {
        const auto order_a = order_of(a.normal), order_b = order_of(b.normal);
        return order_a != order_b ? order_a < order_b : a.loop < b.loop;
    });

    std::map<std::pair<int, int>, int> known;  // edges by their vertices
    hull_.vertices = vertices_;
    hull_.size = hull_.inner_radius = infinity;
    for (std::size_t f = 0; f < sorted.size(); ++f) {
        const auto& [normal, loop] = sorted[f];
        const double offset = support(hull_, normal);
        faces_.push_back({.normal = normal,
                          .offset = offset,
                          .first = static_cast<int>(corners_.size()),
                          .count = static_cast<int>(loop.size()),
                          .clockwise = points_forward(normal)});
        hull_.size = std::min(hull_.size, offset + support(hull_, -normal));
        hull_.inner_radius = std::min(hull_.inner_radius, offset);
        const std::vector<int> sides = sides_of(loop, normal, vertices_);
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const int from = loop[i], to = loop[i + 1 < loop.size() ? i + 1 : 0];
            const auto reverse = known.find({to, from});
            if (reverse != known.end()) {
                HullEdge& edge = edges_[static_cast<std::size_t>(reverse->second)];
                require(edge.right < 0, "an edge of three faces", "two faces at each edge");
                edge.right = static_cast<int>(f);
                corners_.push_back({from, reverse->second, sides[i]});
                continue;
            }
            const auto number = static_cast<int>(edges_.size());
            require(known.emplace(std::pair(from, to), number).second,
                    "an edge that two faces have in one direction",
                    "faces that are counter-clockwise seen from outside");
            const Vector3 way = vertices_[static_cast<std::size_t>(to)] - vertices_[static_cast<std::size_t>(from)];
            edges_.push_back({.from = from,
                              .to = to,
                              .left = static_cast<int>(f),
                              .right = -1,
                              .direction = way.normalized(),
                              .length = way.norm()});
            corners_.push_back({from, number, sides[i]});
        }
    }
    for (HullEdge& edge : edges_) {
        require(edge.right >= 0, "an open edge", "two faces at each edge");
        const double cosine = faces_[static_cast<std::size_t>(edge.left)].normal.dot(
            faces_[static_cast<std::size_t>(edge.right)].normal);
        edge.bulge = 1.0 / std::sqrt(std::max(1e-12, 0.5 * (1.0 + cosine)));
    }
    hull_.faces = faces_;
    hull_.corners = corners_;
    hull_.edges = edges_;
    require(vertices_.size() + faces_.size() == edges_.size() + 2, "a surface with holes or loose vertices",
            "one closed surface");
    require(hull_.inner_radius > 0.0, "the origin outside", "the origin inside");
    for (const HullFace& face : faces_) {
        for (const Hull::Corner& corner : hull_.corners_of(face)) {
            const double height = face.normal.dot(hull_.vertex(corner.vertex)) - face.offset;
            require(height > -bent * std::sqrt(squared_radius_), "a dent or a bent face",
                    "convex, with flat faces");
        }
    }
}

}  // namespace pushfactor::engine::collision
