#include "engine/base/constants.h"
#include "engine/collision/pairs/axis_choice.h"
#include "engine/collision/pairs/clipping.h"
#include "engine/collision/pairs/hull_axes.h"
#include "engine/collision/pairs/pairs.h"

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

// Corner of a clipped face, moved along the normal onto the plane of the other; in the frame of the latter.
struct Corner {
    Vector3 position;    // m
    double gap;          // m along the normal
    std::uint32_t edge;  // label of the edge to the next corner
};

// Labels of edges: numbers in their polyhedron, and whether it is the second one of the pair.
constexpr std::uint32_t of_second_hull = 1u << 10;

Corner between(const Corner& from, const Corner& to, double share) {
    return {from.position + share * (to.position - from.position), from.gap + share * (to.gap - from.gap),
            from.edge};
}

using ClippedFace = Polygon<Corner, Manifold::most_points>;

// The face that is most along `direction` (frame of the hull) among those at the extreme vertices: another one may
// be more so and not reach as far.
int face_along(const Hull& hull, const Vector3& direction) {
    std::array<double, most_vertices> heights;
    double highest = -infinity;
    for (std::size_t i = 0; i < hull.vertices.size(); ++i) {
        heights[i] = direction.dot(hull.vertices[i]);
        highest = std::max(highest, heights[i]);
    }
    const double near = highest - axis_rounding * hull.size;
    int best = 0;
    double most = -infinity;
    for (int f = 0; f < static_cast<int>(hull.faces.size()); ++f) {
        const double along = direction.dot(hull.face(f).normal);
        if (along <= most + 1e-6) continue;
        const auto corners = hull.corners_of(hull.face(f));
        const bool reaches = std::any_of(corners.begin(), corners.end(), [&](const Hull::Corner& corner) {
            return heights[static_cast<std::size_t>(corner.vertex)] >= near;
        });
        if (reaches) most = along, best = f;
    }
    return best;
}

// That of the two faces at an edge.
int face_at(const Hull& hull, int edge, const Vector3& direction) {
    const HullEdge& own = hull.edge(edge);
    return direction.dot(hull.face(own.left).normal) >= direction.dot(hull.face(own.right).normal) ? own.left
                                                                                                   : own.right;
}

// The corners of `other` of b, moved along `normal` (frame of a) onto the plane of `face` of a.
void list_corners(const PlacedHull& a, const HullFace& face, const PlacedHull& b, const HullFace& other,
                  const Vector3& normal, std::uint32_t label, ClippedFace& polygon) {
    const Matrix3 turn = a.pose().rotation.transpose() * b.pose().rotation;
    const Vector3 offset = a.pose().rotation.transpose() * (b.pose().position - a.pose().position);
    const double share = 1.0 / face.normal.dot(normal);
    const auto corners = b.hull().corners_of(other);
    const std::size_t count = corners.size();
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = other.clockwise ? (count - i) % count : i;
        const std::size_t edge = other.clockwise ? (count - i - 1) % count : i;
        const Vector3 place = offset + turn * b.hull().vertex(corners[at].vertex);
        const double gap = share * (face.normal.dot(place) - face.offset);
        polygon.add({place - gap * normal, gap, label + static_cast<std::uint32_t>(corners[edge].edge)});
    }
}

// Two faces that touch: their numbers in the polyhedra.
struct FacePair {
    int of_a, of_b;
};

// Adds the points below `margin` of what two faces have in common along the axis. `flipped`: `a` is the second
// polyhedron of the pair.
void clip_faces(const PlacedHull& a, const PlacedHull& b, FacePair faces, const Separation& axis, bool flipped,
                double margin, Manifold& manifold) {
    const Hull& hull = a.hull();
    const HullFace& face = hull.face(faces.of_a);
    const Pose& pose = a.pose();
    const bool of_edges = axis.of_a >= 0 && axis.of_b >= 0;
    const double tolerance = of_edges ? 0.0 : constants::collision::clip_tolerance * size_of(a, b);  // m
    const Vector3 normal = (flipped ? -1.0 : 1.0) * (pose.rotation.transpose() * axis.normal);
    const std::uint32_t of_a = flipped ? of_second_hull : 0u, of_b = flipped ? 0u : of_second_hull;
    ClippedFace first, second;
    ClippedFace *polygon = &first, *spare = &second;
    list_corners(a, face, b, b.hull().face(faces.of_b), normal, of_b, *polygon);
    const auto corners = hull.corners_of(face);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Hull::Corner& corner = corners[static_cast<std::size_t>(corners[i].side)];
        const HullEdge& edge = hull.edge(corner.edge);
        Vector3 out = edge.direction.cross(face.normal);
        if (edge.from != corner.vertex) out = -out;
        const double offset = out.dot(hull.vertex(corner.vertex)) + tolerance;
        const auto beyond = [&](const Corner& of_polygon) { return out.dot(of_polygon.position) - offset; };
        if (clip(*polygon, beyond, of_a + static_cast<std::uint32_t>(corner.edge), *spare))
            std::swap(polygon, spare);
        if (polygon->count == 0) return;
    }
    for (int i = 0; i < polygon->count; ++i) {
        const Corner& corner = polygon->at(i);
        const double gap = std::max(corner.gap, axis.gap);  // where edges are nearly parallel rounding may lower it
        if (gap >= margin) continue;
        const Vector3 middle = corner.position + (0.5 * gap) * normal;
        manifold.add({pose.position + pose.rotation * middle, gap,
                      corner_of(polygon->at(i + polygon->count - 1).edge, corner.edge)});
    }
}

// Collides the polyhedra along one axis.
void collide_along(const Separation& axis, const PlacedHull& a, const PlacedHull& b, double margin,
                   Manifold& manifold) {
    const Vector3 of_a = a.pose().rotation.transpose() * axis.normal;
    const Vector3 of_b = -(b.pose().rotation.transpose() * axis.normal);
    manifold.normal = axis.normal;
    if (axis.of_b < 0) {
        clip_faces(a, b, {axis.of_a, face_along(b.hull(), of_b)}, axis, false, margin, manifold);
    } else if (axis.of_a < 0) {
        clip_faces(b, a, {axis.of_b, face_along(a.hull(), of_a)}, axis, true, margin, manifold);
    } else {
        const FacePair faces{face_at(a.hull(), axis.of_a, of_a), face_at(b.hull(), axis.of_b, of_b)};
        clip_faces(a, b, faces, axis, false, margin, manifold);
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

    const Separation& best = axes.preferred(constants::collision::axis_preference * size);
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
    Separation along;
    double best = same_axis;
    const auto consider = [&](const PlacedHull& hull, double way, int& of_hull) {
        const Vector3 direction = way * (hull.pose().rotation.transpose() * normal);
        for (int f = 0; f < static_cast<int>(hull.hull().faces.size()); ++f) {
            const double cosine = hull.hull().face(f).normal.dot(direction);
            if (cosine <= best) continue;
            best = cosine;
            along = {.normal = way * (hull.pose().rotation * hull.hull().face(f).normal), .gap = -infinity};
            of_hull = f;
        }
    };
    consider(a, 1.0, along.of_a);
    consider(b, -1.0, along.of_b);
    if (best > same_axis) collide_along(along, a, b, margin, manifold);
}

}  // namespace pushfactor::engine::collision
