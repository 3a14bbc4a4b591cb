// A search of its own over the 15 axes, which keep their names from step to step without a look at any vertex:
// boxes as hulls (polyhedron_pairs.cpp) would have the same contacts at higher cost.
#include "engine/base/constants.h"
#include "engine/collision/pairs/axis_choice.h"
#include "engine/collision/pairs/clipping.h"
#include "engine/collision/pairs/pairs.h"
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

// Corner of a clipped face, seen along the normal on the other.
struct BoxCorner {
    double u, v;    // m, along the two edges of the other face
    double gap;     // m along the normal
    unsigned edge;  // label of the edge to the next corner: 0..11 of the first box, 16..27 of the second
};

BoxCorner between(const BoxCorner& from, const BoxCorner& to, double share) {
    return {from.u + share * (to.u - from.u), from.v + share * (to.v - from.v),
            from.gap + share * (to.gap - from.gap), from.edge};
}

using ClippedQuad = Polygon<BoxCorner, 8>;  // each of four lines adds a corner at most

constexpr unsigned of_second = 16u;

// A face of a box: its axis, and the sign of its outward normal along that axis.
struct Face {
    int axis = 0;
    double sign = 1.0;

    // The number in the box of the face's edge on the side `side` of its axis `across`.
    unsigned edge(int across, double side) const {
        const int along = 3 - axis - across, first = (along + 1) % 3;
        const double one = first == axis ? sign : side, other = first == axis ? side : sign;
        return static_cast<unsigned>(along) * 4u + (one > 0.0 ? 2u : 0u) + (other > 0.0 ? 1u : 0u);
    }
};

// The face whose outward normal is most along `direction`.
Face face_along(const Pose& pose, const Vector3& direction) {
    const Vector3 along = pose.rotation.transpose() * direction;
    int axis = 0;
    for (int i = 1; i < 3; ++i) {
        if (std::abs(along[i]) > std::abs(along[axis]) + 1e-6) axis = i;
    }
    return {axis, along[axis] < 0.0 ? -1.0 : 1.0};
}

// The axis as a unit vector from a to b.
Vector3 axis_between(const BoxAxis& axis, const Pose& pose_a, const Pose& pose_b) {
    Vector3 normal = axis.of_a >= 0 ? pose_a.rotation.col(axis.of_a) : pose_b.rotation.col(axis.of_b);
    if (axis.of_a >= 0 && axis.of_b >= 0) normal = normal.cross(pose_b.rotation.col(axis.of_b)).normalized();
    return normal.dot(pose_b.position - pose_a.position) < 0.0 ? Vector3(-normal) : normal;
}

// Adds the points below `margin` of what the faces of two boxes have in common along `normal`, from `a` to `b`, the
// face of `a` being widened by `tolerance` [m]. `flipped`: `a` is the second box of the pair.
void clip_faces(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b, const Vector3& normal,
                bool flipped, double tolerance, double margin, Manifold& manifold) {
    const Face face = face_along(pose_a, normal), other = face_along(pose_b, -normal);
    const int u_axis = (face.axis + 1) % 3, v_axis = (face.axis + 2) % 3;
    const Vector3 u = pose_a.rotation.col(u_axis), v = pose_a.rotation.col(v_axis);
    const Vector3 out = face.sign * pose_a.rotation.col(face.axis);
    const Vector3 centre = pose_a.position + out * a.half_size[face.axis];

    // The face of b: its centre and half of each edge, moved along the normal onto the plane of the face of a.
    const double share = 1.0 / out.dot(normal), along_u = u.dot(normal), along_v = v.dot(normal);
    const auto seen = [&](const Vector3& vector) {
        const double gap = share * out.dot(vector);
        return Vector3(u.dot(vector) - gap * along_u, v.dot(vector) - gap * along_v, gap);
    };
    const auto half_edge = [&](int axis) { return Vector3(seen(pose_b.rotation.col(axis)) * b.half_size[axis]); };
    const int p_axis = (other.axis + 1) % 3, q_axis = (other.axis + 2) % 3;
    const Vector3 middle = seen(pose_b.position - centre) + other.sign * half_edge(other.axis);
    const Vector3 p = half_edge(p_axis), q = half_edge(q_axis);

    const unsigned of_a = flipped ? of_second : 0u, of_b = flipped ? 0u : of_second;
    ClippedQuad first, second;
    ClippedQuad *polygon = &first, *spare = &second;
    const auto add = [&](const Vector3& corner, unsigned edge) {
        polygon->add({middle[0] + corner[0], middle[1] + corner[1], middle[2] + corner[2], of_b + edge});
    };
    add(p + q, other.edge(p_axis, 1.0));
    add(p - q, other.edge(q_axis, -1.0));
    add(-p - q, other.edge(p_axis, -1.0));
    add(q - p, other.edge(q_axis, 1.0));
    for (unsigned side = 0; side < 4 && polygon->count > 0; ++side) {
        // Within a limit along +-u or +-v.
        const int across = side < 2 ? u_axis : v_axis;
        const double way = (side & 1u) ? -1.0 : 1.0, limit = a.half_size[across] + tolerance;
        const auto beyond = [side, way, limit](const BoxCorner& corner) {
            return way * (side < 2 ? corner.u : corner.v) - limit;
        };
        if (clip(*polygon, beyond, of_a + face.edge(across, way), *spare)) std::swap(polygon, spare);
    }
    for (int i = 0; i < polygon->count; ++i) {
        const BoxCorner& corner = polygon->at(i);
        if (corner.gap >= margin) continue;
        const Vector3 position = centre + u * corner.u + v * corner.v + normal * (0.5 * corner.gap);
        manifold.add({position, corner.gap, corner_of(polygon->at(i + polygon->count - 1).edge, corner.edge)});
    }
}

// Collides the boxes along one axis.
void collide_along(const BoxAxis& axis, const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b,
                   double margin, Manifold& manifold) {
    const double tolerance = constants::collision::clip_tolerance * size_of(a, b);  // m
    const Vector3 normal = axis_between(axis, pose_a, pose_b);
    manifold.normal = normal;
    if (axis.of_a < 0) {
        clip_faces(b, pose_b, a, pose_a, -normal, true, tolerance, margin, manifold);
    } else {
        clip_faces(a, pose_a, b, pose_b, normal, false, axis.of_b < 0 ? tolerance : 0.0, margin, manifold);
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
    const BoxAxis& best = axes.preferred(constants::collision::axis_preference * size);
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
