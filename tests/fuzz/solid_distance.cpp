#include "tests/fuzz/solid_distance.h"

#include "demos/scenes/convex_hull.h"
#include "engine/base/overloaded.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace pushfactor::tests {

namespace {

using engine::infinity;
using engine::Vector3;

const Vector3& at(const std::vector<Vector3>& vectors, int index) {
    return vectors[static_cast<std::size_t>(index)];
}

double greatest(const std::vector<Vector3>& points, const Vector3& direction) {
    double most = -infinity;
    for (const Vector3& point : points) most = std::max(most, direction.dot(point));
    return most;
}

Solid ball(double radius) {
    return {.points = {Vector3::Zero()}, .faces = {}, .edges = {{0, 0}}, .radius = radius, .size = 2.0 * radius};
}

// By Newell's sum, which uses all corners.
Vector3 normal_of(const std::vector<Vector3>& points, const std::vector<int>& corners) {
    Vector3 sum = Vector3::Zero();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        sum += at(points, corners[i]).cross(at(points, corners[(i + 1) % corners.size()]));
    }
    return sum.normalized();
}

Solid polyhedron(const std::vector<Vector3>& points) {
    const demos::ConvexHull hull = demos::convex_hull(points);
    Solid solid{.points = hull.points, .faces = {}, .edges = {}, .size = infinity};
    std::set<std::pair<int, int>> edges;
    for (const std::vector<int>& corners : hull.faces) {
        const Vector3 normal = normal_of(hull.points, corners);
        solid.faces.push_back({normal, corners});
        solid.size = std::min(solid.size, greatest(hull.points, normal) + greatest(hull.points, -normal));
        for (std::size_t i = 0; i < corners.size(); ++i) {
            edges.insert(std::minmax({corners[i], corners[(i + 1) % corners.size()]}));
        }
    }
    solid.edges.assign(edges.begin(), edges.end());
    for (const Vector3& point : solid.points) solid.turning_radius = std::max(solid.turning_radius, point.norm());
    return solid;
}

Solid box(const Vector3& size) {
    std::vector<Vector3> corners;
    for (const double x : {-0.5, 0.5}) {
        for (const double y : {-0.5, 0.5}) {
            for (const double z : {-0.5, 0.5}) corners.push_back(Vector3(x, y, z).cwiseProduct(size));
        }
    }
    return polyhedron(corners);
}

double core_gap(const PlacedSolid& a, const PlacedSolid& b, const Vector3& normal) {
    return -greatest(b.points, -normal) - greatest(a.points, normal);
}

// Calls `visit` with the normals of all faces and of all pairs of edges that can be the direction of the largest
// gap, from a to b, and with the gap [m] of the cores along them. Pairs of edges with a gap below `least()` are
// left out.
template <typename Visit, typename Least>
void visit_axes(const PlacedSolid& a, const PlacedSolid& b, const Visit& visit, const Least& least) {
    for (const Vector3& normal : a.normals) visit(normal, core_gap(a, b, normal));
    for (const Vector3& normal : b.normals) visit(-normal, core_gap(a, b, -normal));
    for (const auto& [a0, a1] : a.solid->edges) {
        const Vector3 edge_a = at(a.points, a1) - at(a.points, a0);
        for (const auto& [b0, b1] : b.solid->edges) {
            const Vector3 edge_b = at(b.points, b1) - at(b.points, b0);
            Vector3 normal = edge_a.cross(edge_b);
            const double length = normal.norm();
            if (length <= 1e-9 * edge_a.norm() * edge_b.norm() || length == 0.0) continue;
            normal /= length;
            if (normal.dot(at(a.points, a0) - a.position) < 0.0) normal = -normal;
            // The gap is at most that of these two edges.
            if (normal.dot(at(b.points, b0) - at(a.points, a0)) >= least()) {
                visit(normal, core_gap(a, b, normal));
            }
        }
    }
}

using Points = std::pair<Vector3, Vector3>;

// Closest points of two segments. Four ends against the other segment, and the two lines where both points are
// inside.
struct Segment {
    Vector3 from, along;

    Vector3 closest_to(const Vector3& point) const {
        const double square = along.squaredNorm();
        if (square == 0.0) return from;
        return from + std::clamp(along.dot(point - from) / square, 0.0, 1.0) * along;
    }
};

class Closest {
  public:
    void offer(const Vector3& a, const Vector3& b) {
        const double square = (b - a).squaredNorm();
        if (square < square_) {
            square_ = square;
            points_ = {a, b};
        }
    }
    const Points& points() const { return points_; }

  private:
    double square_ = infinity;
    Points points_;
};

void offer_segments(const Segment& a, const Segment& b, Closest& closest) {
    for (const Vector3& end : {Vector3(b.from), Vector3(b.from + b.along)}) closest.offer(a.closest_to(end), end);
    for (const Vector3& end : {Vector3(a.from), Vector3(a.from + a.along)}) closest.offer(end, b.closest_to(end));
    const Vector3 between = b.from - a.from;
    const double aa = a.along.squaredNorm(), bb = b.along.squaredNorm(), ab = a.along.dot(b.along);
    const double determinant = a.along.cross(b.along).squaredNorm();
    if (determinant <= 1e-18 * aa * bb) return;  // parallel: the ends decide
    const double s = (bb * a.along.dot(between) - ab * b.along.dot(between)) / determinant;
    const double t = (ab * a.along.dot(between) - aa * b.along.dot(between)) / determinant;
    if (s < 0.0 || s > 1.0 || t < 0.0 || t > 1.0) return;
    closest.offer(a.from + s * a.along, b.from + t * b.along);
}

bool lies_above(const PlacedSolid& solid, const Solid::Face& face, const Vector3& normal, const Vector3& point) {
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
        const Vector3& from = at(solid.points, face.corners[i]);
        const Vector3& to = at(solid.points, face.corners[(i + 1) % face.corners.size()]);
        if (normal.dot((to - from).cross(point - from)) < 0.0) return false;
    }
    return true;
}

// Calls `offer` with the points of `points` above faces of `solid`, and the points below them on the face.
template <typename Offer>
void visit_points_above(const PlacedSolid& solid, const std::vector<Vector3>& points, const Offer& offer) {
    for (std::size_t f = 0; f < solid.normals.size(); ++f) {
        const Solid::Face& face = solid.solid->faces[f];
        const Vector3& normal = solid.normals[f];
        for (const Vector3& point : points) {
            const double height = normal.dot(point - at(solid.points, face.corners[0]));
            if (height > 0.0 && lies_above(solid, face, normal, point)) offer(point, point - height * normal);
        }
    }
}

}  // namespace

Solid solid_of(const demos::BodyDescription& body) {
    return std::visit(engine::Overloaded{[](const demos::BoxShape& shape) { return box(shape.size); },
                                         [](const demos::SphereShape& shape) { return ball(shape.radius); },
                                         [](const demos::PlaneShape&) { return Solid{}; },
                                         [](const demos::PolyhedronShape& shape) {
                                             return polyhedron({shape.points().begin(), shape.points().end()});
                                         }},
                      body.shape);
}

PlacedSolid::PlacedSolid(const Solid& which, const Vector3& where, const engine::Quaternion& orientation)
    : solid(&which), position(where) {
    const engine::Matrix3 rotation = orientation.toRotationMatrix();
    points.reserve(which.points.size());
    normals.reserve(which.faces.size());
    for (const Vector3& point : which.points) points.emplace_back(position + rotation * point);
    for (const Solid::Face& face : which.faces) normals.emplace_back(rotation * face.normal);
}

double gap_along(const PlacedSolid& a, const PlacedSolid& b, const Vector3& normal) {
    return core_gap(a, b, normal) - a.solid->radius - b.solid->radius;
}

Points closest_points(const PlacedSolid& a, const PlacedSolid& b) {
    Closest closest;
    visit_points_above(a, b.points,
                       [&](const Vector3& point, const Vector3& below) { closest.offer(below, point); });
    visit_points_above(b, a.points,
                       [&](const Vector3& point, const Vector3& below) { closest.offer(point, below); });
    for (const auto& [a0, a1] : a.solid->edges) {
        const Segment edge{at(a.points, a0), at(a.points, a1) - at(a.points, a0)};
        for (const auto& [b0, b1] : b.solid->edges) {
            offer_segments(edge, {at(b.points, b0), at(b.points, b1) - at(b.points, b0)}, closest);
        }
    }
    return closest.points();
}

Closeness closeness(const PlacedSolid& a, const PlacedSolid& b) {
    const double radii = a.solid->radius + b.solid->radius;
    Closeness best{-infinity, Vector3::UnitY()};
    visit_axes(
        a, b,
        [&](const Vector3& normal, double gap) {
            if (gap > best.distance) best = {gap, normal};
        },
        [&] { return best.distance; });
    const bool two_balls = a.normals.empty() && b.normals.empty();
    if (best.distance > 0.0 || two_balls) {
        const auto [on_a, on_b] = closest_points(a, b);
        const double distance = (on_b - on_a).norm();
        // Of closest points without a distance only the direction of the gap is known.
        if (distance > 1e-12) best = {distance, (on_b - on_a) / distance};
        if (two_balls && distance <= 1e-12) best.distance = 0.0;
    }
    best.distance -= radii;
    return best;
}

double next_gap(const PlacedSolid& a, const PlacedSolid& b, const Vector3& normal, double angle) {
    if (a.normals.empty() || b.normals.empty()) return -infinity;
    const double least_sine = std::sin(angle);
    double next = -infinity;
    visit_axes(
        a, b,
        [&](const Vector3& axis, double gap) {
            const bool other = axis.dot(normal) < 0.0 || axis.cross(normal).norm() > least_sine;
            if (other) next = std::max(next, gap);
        },
        [&] { return next; });
    return next;
}

}  // namespace pushfactor::tests
