#include "engine/collision/pairs/polyhedron_pairs.h"

#include "engine/collision/pairs/axis_choice.h"
#include "engine/collision/pairs/clipping.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace pushfactor::engine::collision {

namespace {

double size_of(const PlacedHull& a, const PlacedHull& b) {
    return std::min(a.hull().size, b.hull().size);
}

using Axes = BestAxes<Separation>;

// The face axes of the pair that matter, for later looks: those whose gap may reach some limit.
struct FaceGaps {
    static constexpr std::size_t most = 4 * most_vertices;  // faces of both
    std::array<Separation, most> storage;
    std::size_t count = 0;
    FaceGaps() {}  // NOLINT(modernize-use-equals-default): the storage stays uninitialised
    void add(const Separation& separation) { storage[count++] = separation; }
    std::span<const Separation> all() const& { return {storage.data(), count}; }
    std::span<const Separation> all() const&& = delete;  // would dangle
};

// Best separation of each of the three groups of axes.
Axes separate(const HullAxes& axes, double rounding, double much, double margin, FaceGaps& faces) {
    Axes best;
    best.face_a.gap = best.face_b.gap = best.edges.gap = -infinity;
    axes.visit_faces(std::min(-much, axes.large_face_gap() - 2.0 * rounding), [&](const Separation& separation) {
        faces.add(separation);
        Separation& group = separation.of_b < 0 ? best.face_a : best.face_b;
        if (separation.gap > group.gap + rounding) group = separation;
    });
    if (best.largest() >= margin) return best;
    axes.visit_edges(best.largest_face() + rounding, [&](const Separation& separation) {
        if (separation.gap > best.edges.gap + rounding) best.edges = separation;
    });
    return best;
}

// Corner of the clipped incident face, in the frame of the reference polyhedron.
struct Corner {
    Vector3 position;    // m
    std::uint32_t edge;  // label of the edge to the next corner
};

// Labels of edges: numbers in their polyhedron, and whether it is the reference.
constexpr std::uint32_t of_reference = 1u << 10;

Corner between(const Corner& from, const Corner& to, double share) {
    return {from.position + share * (to.position - from.position), from.edge};
}

using ClippedFace = Polygon<Corner, Manifold::most_points>;

// The face that is most against `normal` (frame of the hull) among those at the extreme vertices: another one may
// be more so and not reach as far.
int incident_face(const Hull& hull, const Vector3& normal) {
    std::array<double, most_vertices> heights;
    double lowest = infinity;
    for (std::size_t i = 0; i < hull.vertices.size(); ++i) {
        heights[i] = normal.dot(hull.vertices[i]);
        lowest = std::min(lowest, heights[i]);
    }
    const double near = lowest + axis_rounding * hull.size;
    int best = 0;
    double most = -infinity;
    for (int f = 0; f < static_cast<int>(hull.faces.size()); ++f) {
        const double against = -normal.dot(hull.face(f).normal);
        if (against <= most + 1e-6) continue;
        const auto corners = hull.corners_of(hull.face(f));
        const bool reaches = std::any_of(corners.begin(), corners.end(), [&](const Hull::Corner& corner) {
            return heights[static_cast<std::size_t>(corner.vertex)] <= near;
        });
        if (reaches) most = against, best = f;
    }
    return best;
}

// The incident face of `other` in the frame of `reference`.
void list_corners(const PlacedHull& reference, const PlacedHull& other, int number, ClippedFace& polygon) {
    const HullFace& face = other.hull().face(number);
    const Matrix3 turn = reference.pose().rotation.transpose() * other.pose().rotation;
    const Vector3 offset =
        reference.pose().rotation.transpose() * (other.pose().position - reference.pose().position);
    const auto corners = other.hull().corners_of(face);
    const std::size_t count = corners.size();
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = face.clockwise ? (count - i) % count : i;
        const std::size_t edge = face.clockwise ? (count - i - 1) % count : i;
        polygon.add({offset + turn * other.hull().vertex(corners[at].vertex),
                     static_cast<std::uint32_t>(corners[edge].edge)});
    }
}

// Clips the incident face of `other` to the face `number` of `reference` and adds the points below `margin`.
// `flipped`: the reference is b.
void clip_faces(const PlacedHull& reference, int number, const PlacedHull& other, bool flipped, double tolerance,
                double margin, Manifold& manifold) {
    const Hull& hull = reference.hull();
    const HullFace& face = hull.face(number);
    const Pose& pose = reference.pose();
    const Vector3 normal = pose.rotation * face.normal;
    manifold.normal = flipped ? Vector3(-normal) : normal;

    ClippedFace first, second;
    ClippedFace *polygon = &first, *spare = &second;
    list_corners(reference, other, incident_face(other.hull(), other.pose().rotation.transpose() * normal),
                 *polygon);
    const auto corners = hull.corners_of(face);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Hull::Corner& corner = corners[static_cast<std::size_t>(corners[i].side)];
        const HullEdge& edge = hull.edge(corner.edge);
        Vector3 out = edge.direction.cross(face.normal);
        if (edge.from != corner.vertex) out = -out;
        const double offset = out.dot(hull.vertex(corner.vertex)) + tolerance;
        const auto beyond = [&](const Corner& of_polygon) { return out.dot(of_polygon.position) - offset; };
        const std::uint32_t side = of_reference | static_cast<std::uint32_t>(corner.edge);
        if (clip(*polygon, beyond, side, *spare)) std::swap(polygon, spare);
        if (polygon->count == 0) return;
    }

    const std::uint32_t of_face = (flipped ? 1u << 31 : 0u) | static_cast<std::uint32_t>(number) << 22;
    for (int i = 0; i < polygon->count; ++i) {
        const Corner& corner = polygon->at(i);
        const double height = face.normal.dot(corner.position) - face.offset;
        if (height >= margin) continue;
        const std::uint32_t before = polygon->at(i + polygon->count - 1).edge;
        const Vector3 middle = corner.position - (0.5 * height) * face.normal;
        manifold.add({pose.position + pose.rotation * middle, height, of_face | before << 11 | corner.edge});
    }
}

// Adds the point midway between the closest points of the two edges.
void cross_edges(const PlacedHull& a, const PlacedHull& b, const Separation& axis, double margin,
                 Manifold& manifold) {
    const HullEdge& edge_a = a.hull().edge(axis.of_a);
    const HullEdge& edge_b = b.hull().edge(axis.of_b);
    const Vector3 from_a = a.pose().position + a.pose().rotation * a.hull().vertex(edge_a.from);
    const Vector3 from_b = b.pose().position + b.pose().rotation * b.hull().vertex(edge_b.from);
    const Vector3 along_a = a.pose().rotation * edge_a.direction;
    const Vector3 along_b = b.pose().rotation * edge_b.direction;

    manifold.normal = axis.normal;
    constexpr std::uint32_t of_edges = 511u << 22;  // no face has this number
    const EdgePoints points =
        closest_points({from_a, along_a, 0.0, edge_a.length}, {from_b, along_b, 0.0, edge_b.length});
    const double gap = gap_between(points, axis.gap);
    if (gap >= margin) return;
    manifold.add({points.middle(), gap,
                  of_edges | static_cast<std::uint32_t>(axis.of_a) << 11 | static_cast<std::uint32_t>(axis.of_b)});
}

void collide_along(const Separation& axis, const PlacedHull& a, const PlacedHull& b, double margin,
                   Manifold& manifold) {
    const double tolerance = clip_tolerance * size_of(a, b);
    if (axis.of_b < 0) {
        clip_faces(a, axis.of_a, b, false, tolerance, margin, manifold);
    } else if (axis.of_a < 0) {
        clip_faces(b, axis.of_b, a, true, tolerance, margin, manifold);
    } else {
        cross_edges(a, b, axis, margin, manifold);
    }
}

}  // namespace

void collide_hulls(const PlacedHull& a, const PlacedHull& b, double margin, Manifold& manifold) {
    const double size = size_of(a, b);
    const double much = 0.05 * std::max(a.hull().size, b.hull().size);  // m of overlap
    FaceGaps faces;
    const HullAxes all(a, b);
    const Axes axes = separate(all, axis_rounding * size, much, margin, faces);
    manifold.separation = axes.largest();
    if (manifold.separation >= margin) {
        manifold.normal = axes.preferred(0.0).normal;
        return;
    }

    const Separation& best = axes.preferred(axis_preference * size);
    collide_along(best, a, b, margin, manifold);
    // What is below a preferred face may be beside it.
    if (manifold.count == 0 && best.gap < axes.largest())
        collide_along(axes.preferred(0.0), a, b, margin, manifold);
    GapOfOthers others(manifold.normal, much);
    for (const Separation& face : faces.all()) others.consider(face.gap, face.normal);
    manifold.other_gap = others.largest();
}

void collide_hulls_along(const Vector3& normal, const PlacedHull& a, const PlacedHull& b, double margin,
                         Manifold& manifold) {
    Separation along{.normal = normal};
    double best = same_axis;
    const auto consider = [&](const PlacedHull& hull, double way, int& of_hull) {
        const Vector3 direction = way * (hull.pose().rotation.transpose() * normal);
        for (int f = 0; f < static_cast<int>(hull.hull().faces.size()); ++f) {
            const double cosine = hull.hull().face(f).normal.dot(direction);
            if (cosine <= best) continue;
            best = cosine;
            along = {.normal = normal};
            of_hull = f;
        }
    };
    consider(a, 1.0, along.of_a);
    consider(b, -1.0, along.of_b);
    if (best > same_axis) collide_along(along, a, b, margin, manifold);
}

}  // namespace pushfactor::engine::collision
