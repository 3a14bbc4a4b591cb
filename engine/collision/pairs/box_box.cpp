// Choices that the paper leaves open, besides those of axis_choice.h:
// - the incident face is the most anti-parallel one;
// - two crossing edges make one point, midway between their closest points.
//
// A search of its own over the 15 axes, which keep their names from step to step without a look at any vertex:
// boxes as hulls (polyhedron_pairs.h) would have the same contacts at higher cost.
#include "engine/collision/pairs/box_box.h"

#include "engine/collision/pairs/axis_choice.h"
#include "engine/collision/pairs/clipping.h"
#include "engine/collision/pairs/separations.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pushfactor::engine::collision {

namespace {

// Candidate axis: a face axis of one box, or two edge directions, 0..2; -1 where there is none.
struct BoxAxis {
    double gap = -infinity;  // m, negative while the boxes overlap
    int of_a = -1;
    int of_b = -1;
};

struct BoxAxes : BestAxes<BoxAxis> {
    std::array<double, 3> faces_a, faces_b;  // gaps along the face axes [m]
};

double size_of(const Box& a, const Box& b) {
    return 2.0 * std::min(a.half_size.minCoeff(), b.half_size.minCoeff());
}

// Best separation of each of the three groups of axes: face axes of a, face axes of b, cross products of edges;
// computed in a's frame. An edge axis is normalised only if it could beat the axes before it.
BoxAxes separate(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b, double margin) {
    const Matrix3 R = pose_a.rotation.transpose() * pose_b.rotation;  // b's axes in a's frame
    const Matrix3 absR = R.cwiseAbs();
    const Vector3 t = pose_a.rotation.transpose() * (pose_b.position - pose_a.position);
    const Vector3 &A = a.half_size, &B = b.half_size;
    const double rounding = axis_rounding * size_of(a, b);

    BoxAxes best;
    for (int i = 0; i < 3; ++i) {
        const double on_a = std::abs(t[i]) - A[i] - (absR(i, 0) * B[0] + absR(i, 1) * B[1] + absR(i, 2) * B[2]);
        best.faces_a[static_cast<std::size_t>(i)] = on_a;
        if (on_a > best.face_a.gap + rounding) best.face_a = {on_a, i, -1};
        const double along = t[0] * R(0, i) + t[1] * R(1, i) + t[2] * R(2, i);
        const double on_b = std::abs(along) - B[i] - (absR(0, i) * A[0] + absR(1, i) * A[1] + absR(2, i) * A[2]);
        best.faces_b[static_cast<std::size_t>(i)] = on_b;
        if (on_b > best.face_b.gap + rounding) best.face_b = {on_b, -1, i};
    }
    if (best.largest() >= margin) return best;
    for (int i = 0; i < 3; ++i) {
        const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
        for (int j = 0; j < 3; ++j) {
            const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            // The axis e_i x R e_j is shorter than 1, so normalising makes a negative separation only worse.
            const double reach =
                A[i1] * absR(i2, j) + A[i2] * absR(i1, j) + B[j1] * absR(i, j2) + B[j2] * absR(i, j1);
            const double separation = std::abs(t[i2] * R(i1, j) - t[i1] * R(i2, j)) - reach;
            if (separation <= std::min(0.0, best.largest())) continue;
            const double length = std::sqrt(R(i1, j) * R(i1, j) + R(i2, j) * R(i2, j));
            if (length < parallel_edges) continue;  // the adjacent faces cover this direction
            if (separation / length > best.edges.gap) best.edges = {separation / length, i, j};
        }
    }
    return best;
}

// Corner of the clipped incident face, in the frame of the reference face.
struct BoxCorner {
    double u, v;    // m, along the two edges of the reference face
    double height;  // m above it
    unsigned edge;  // label of the edge to the next corner: 0..3 of the face, 4..7 made by that clipping side
};

BoxCorner between(const BoxCorner& from, const BoxCorner& to, double share) {
    return {from.u + share * (to.u - from.u), from.v + share * (to.v - from.v),
            from.height + share * (to.height - from.height), from.edge};
}

using ClippedQuad = Polygon<BoxCorner, 8>;  // each of four lines adds a corner at most

// A face of a box: its axis, and the sign of its outward normal along that axis.
struct Face {
    int axis = 0;
    double sign = 1.0;

    unsigned label() const { return static_cast<unsigned>(axis) * 2u + (sign > 0.0 ? 1u : 0u); }
};

Face most_antiparallel(const Pose& pose, const Vector3& normal) {
    const Vector3 along = pose.rotation.transpose() * normal;
    int axis = 0;
    for (int i = 1; i < 3; ++i) {
        if (std::abs(along[i]) > std::abs(along[axis]) + 1e-6) axis = i;
    }
    return {axis, along[axis] > 0.0 ? -1.0 : 1.0};
}

// Clips the incident face of `other` to the face `face` of `reference` and adds the points below `margin`.
// `flipped`: the reference box is b.
void clip_faces(const Box& reference, const Pose& reference_pose, Face face, const Box& other,
                const Pose& other_pose, bool flipped, double tolerance, double margin, Manifold& manifold) {
    const Vector3 normal = face.sign * reference_pose.rotation.col(face.axis);
    const int u_axis = (face.axis + 1) % 3;
    const int v_axis = (face.axis + 2) % 3;
    const Vector3 u = reference_pose.rotation.col(u_axis);
    const Vector3 v = reference_pose.rotation.col(v_axis);
    const Vector3 centre = reference_pose.position + normal * reference.half_size[face.axis];

    // The incident face in the frame of the reference face: its centre, and half of each edge.
    const auto seen = [&](const Vector3& vector) {
        return Vector3(u.dot(vector), v.dot(vector), normal.dot(vector));
    };
    const auto half_edge = [&](int axis) {
        return Vector3(seen(other_pose.rotation.col(axis)) * other.half_size[axis]);
    };
    const Face incident = most_antiparallel(other_pose, normal);
    const Vector3 middle = seen(other_pose.position - centre) + incident.sign * half_edge(incident.axis);
    const Vector3 p = half_edge((incident.axis + 1) % 3);
    const Vector3 q = half_edge((incident.axis + 2) % 3);

    ClippedQuad first, second;
    ClippedQuad *polygon = &first, *spare = &second;
    unsigned edge = 0;
    for (const Vector3& corner : {Vector3(p + q), Vector3(p - q), Vector3(-p - q), Vector3(q - p)}) {
        polygon->add({middle[0] + corner[0], middle[1] + corner[1], middle[2] + corner[2], edge++});
    }
    for (unsigned side = 0; side < 4 && polygon->count > 0; ++side) {
        // Within a limit along +-u or +-v.
        const double limit = reference.half_size[side < 2 ? u_axis : v_axis] + tolerance;
        const auto beyond = [side, limit](const BoxCorner& corner) {
            const double coordinate = side < 2 ? corner.u : corner.v;
            return ((side & 1u) ? -coordinate : coordinate) - limit;
        };
        if (clip(*polygon, beyond, 4 + side, *spare)) std::swap(polygon, spare);
    }

    manifold.normal = flipped ? Vector3(-normal) : normal;
    const unsigned faces = (flipped ? 64u : 0u) + face.label() * 8u + incident.label();
    for (int i = 0; i < polygon->count; ++i) {
        const BoxCorner& corner = polygon->at(i);
        if (corner.height >= margin) continue;
        const unsigned before = polygon->at(i + polygon->count - 1).edge;
        const Vector3 position = centre + u * corner.u + v * corner.v + normal * (0.5 * corner.height);
        manifold.add({position, corner.height, (faces * 8u + before) * 8u + corner.edge});
    }
}

double sign_of(double value) {
    return value < 0.0 ? -1.0 : 1.0;
}

// The axis as a unit vector from a to b.
Vector3 axis_between(const BoxAxis& axis, const Pose& pose_a, const Pose& pose_b) {
    Vector3 normal = axis.of_a >= 0 ? pose_a.rotation.col(axis.of_a) : pose_b.rotation.col(axis.of_b);
    if (axis.of_a >= 0 && axis.of_b >= 0) normal = normal.cross(pose_b.rotation.col(axis.of_b)).normalized();
    return normal.dot(pose_b.position - pose_a.position) < 0.0 ? Vector3(-normal) : normal;
}

// Adds the point midway between the closest points of the two edges that face each other along the axis.
void cross_edges(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b, const BoxAxis& axis,
                 double margin, Manifold& manifold) {
    const Vector3 edge_a = pose_a.rotation.col(axis.of_a);
    const Vector3 edge_b = pose_b.rotation.col(axis.of_b);
    const Vector3 normal = axis_between(axis, pose_a, pose_b);

    // Midpoints of the edges: farthest along the normal on a, against it on b.
    Vector3 corner_a = pose_a.position;
    Vector3 corner_b = pose_b.position;
    unsigned which = 0;
    for (int k = 0; k < 3; ++k) {
        const double side_a = sign_of(normal.dot(pose_a.rotation.col(k)));
        const double side_b = sign_of(normal.dot(pose_b.rotation.col(k)));
        which *= 4u;
        // Along the edges themselves the signs are rounding noise.
        if (k != axis.of_a) {
            corner_a += pose_a.rotation.col(k) * (side_a * a.half_size[k]);
            which += side_a > 0.0 ? 2u : 0u;
        }
        if (k != axis.of_b) {
            corner_b -= pose_b.rotation.col(k) * (side_b * b.half_size[k]);
            which += side_b > 0.0 ? 1u : 0u;
        }
    }

    const double half_a = a.half_size[axis.of_a], half_b = b.half_size[axis.of_b];
    manifold.normal = normal;
    const auto edges = static_cast<unsigned>(axis.of_a * 3 + axis.of_b);
    const EdgePoints points =
        closest_points({corner_a, edge_a, -half_a, half_a}, {corner_b, edge_b, -half_b, half_b});
    const double gap = gap_between(points, axis.gap);
    if (gap < margin) manifold.add({points.middle(), gap, (1u << 16) + edges * 64u + which});
}

// Collides the boxes along one axis.
void collide_along(const BoxAxis& axis, const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b,
                   double margin, Manifold& manifold) {
    const double tolerance = clip_tolerance * size_of(a, b);  // m, by which the reference face is widened
    const Vector3 offset = pose_b.position - pose_a.position;
    if (axis.of_b < 0) {
        const Face face{axis.of_a, sign_of(pose_a.rotation.col(axis.of_a).dot(offset))};
        clip_faces(a, pose_a, face, b, pose_b, false, tolerance, margin, manifold);
    } else if (axis.of_a < 0) {
        const Face face{axis.of_b, -sign_of(pose_b.rotation.col(axis.of_b).dot(offset))};
        clip_faces(b, pose_b, face, a, pose_a, true, tolerance, margin, manifold);
    } else {
        cross_edges(a, pose_a, b, pose_b, axis, margin, manifold);
    }
}

}  // namespace

void collide_box_box(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b, double margin,
                     Manifold& manifold) {
    const BoxAxes axes = separate(a, pose_a, b, pose_b, margin);
    manifold.separation = axes.largest();
    if (manifold.separation >= margin) {
        manifold.normal = axis_between(axes.preferred(0.0), pose_a, pose_b);
        return;
    }

    const double size = size_of(a, b);
    const BoxAxis& best = axes.preferred(axis_preference * size);
    collide_along(best, a, pose_a, b, pose_b, margin, manifold);
    // What is below a preferred face may be beside it.
    if (manifold.count == 0 && best.gap < axes.largest()) {
        collide_along(axes.preferred(0.0), a, pose_a, b, pose_b, margin, manifold);
    }

    const double much = 0.1 * std::max(a.half_size.minCoeff(), b.half_size.minCoeff());  // m of overlap
    GapOfOthers others(manifold.normal, much);
    for (int i = 0; i < 3; ++i) {
        others.consider(axes.faces_a[static_cast<std::size_t>(i)], pose_a.rotation.col(i));
        others.consider(axes.faces_b[static_cast<std::size_t>(i)], pose_b.rotation.col(i));
    }
    manifold.other_gap = others.largest();
}

}  // namespace pushfactor::engine::collision
