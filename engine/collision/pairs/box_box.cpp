// Paper section 4: "a separating axis test is used", "clipping the most penetrating face of the first polyhedron
// to the volume below the corresponding anti-parallel face on the second".
//
// Choices that the paper leaves open:
// - among the axes of one box that tie up to rounding, as in every row of touching boxes, the first one is taken;
// - the reference face is a's unless b's separates clearly better, and an edge pair has to be clearly better
//   than both: a choice that rounding could flip would change the features and lose the cached forces;
// - the incident face is the most anti-parallel one;
// - the reference face is widened by a small tolerance before clipping, because with exactly aligned faces the
//   corners of the incident face lie on its sides and would be clipped in one step and kept in the next;
// - two crossing edges make one point, midway between their closest points.
#include "engine/collision/pairs/box_box.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine::collision {

namespace {

constexpr double axis_preference = 5e-4;  // of the smaller box's shortest edge, for the choice of the axis
constexpr double axis_rounding = 1e-6;    // the same, among the axes of one box; within it the first one wins
constexpr double clip_tolerance = 2e-4;   // the same, by which the reference face is widened
constexpr double same_direction = 0.9;    // cosine above which two axes count as the same direction

// Candidate axis of least penetration.
struct Axis {
    double separation = -std::numeric_limits<double>::infinity();  // m, negative while the boxes overlap
    int of_a = 0;                                                  // face axis or edge direction of a, 0..2
    int of_b = 0;                                                  // of b
};

struct Axes {
    Axis face_a, face_b, edges;
    std::array<double, 3> faces_a, faces_b;  // separations along the face axes [m]

    double largest() const { return std::max({face_a.separation, face_b.separation, edges.separation}); }
};

double size_of(const Box& a, const Box& b) {
    return 2.0 * std::min(a.half_size.minCoeff(), b.half_size.minCoeff());
}

// Best separation of each of the three groups of axes: face axes of a, face axes of b, cross products of edges;
// computed in a's frame. An edge axis is normalised only if it could beat the axes before it.
Axes separate(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b, double margin) {
    const Matrix3 R = pose_a.rotation.transpose() * pose_b.rotation;  // b's axes in a's frame
    const Matrix3 absR = R.cwiseAbs();
    const Vector3 t = pose_a.rotation.transpose() * (pose_b.position - pose_a.position);
    const Vector3 &A = a.half_size, &B = b.half_size;
    const double rounding = axis_rounding * size_of(a, b);

    Axes best;
    for (int i = 0; i < 3; ++i) {
        const double on_a = std::abs(t[i]) - A[i] - (absR(i, 0) * B[0] + absR(i, 1) * B[1] + absR(i, 2) * B[2]);
        best.faces_a[static_cast<std::size_t>(i)] = on_a;
        if (on_a > best.face_a.separation + rounding) best.face_a = {on_a, i, 0};
        const double along = t[0] * R(0, i) + t[1] * R(1, i) + t[2] * R(2, i);
        const double on_b = std::abs(along) - B[i] - (absR(0, i) * A[0] + absR(1, i) * A[1] + absR(2, i) * A[2]);
        best.faces_b[static_cast<std::size_t>(i)] = on_b;
        if (on_b > best.face_b.separation + rounding) best.face_b = {on_b, 0, i};
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
            if (separation / length > best.edges.separation) best.edges = {separation / length, i, j};
        }
    }
    return best;
}

// Corner of the clipped incident face, in the frame of the reference face.
struct Corner {
    double u, v;    // m, along the two edges of the reference face
    double height;  // m above it
    unsigned edge;  // label of the edge to the next corner: 0..3 of the face, 4..7 made by that clipping side
};

struct Polygon {
    // The first `count` are valid. A quadrilateral clipped by four lines has at most eight corners; rounding
    // could add a sliver corner that coincides with the one before it.
    std::array<Corner, 8> corners;
    int count = 0;

    void add(const Corner& corner) {
        if (count < 8) corners[static_cast<std::size_t>(count++)] = corner;
    }
    const Corner& at(int i) const {
        return corners[static_cast<std::size_t>(i < count ? i : i - count)];
    }  // i < 2 count
};

Corner between(const Corner& from, const Corner& to, double share) {
    return {from.u + share * (to.u - from.u), from.v + share * (to.v - from.v),
            from.height + share * (to.height - from.height), from.edge};
}

// Sutherland-Hodgman against one side of the reference face: keeps the part within `limit` along +-u or +-v.
void clip(Polygon& polygon, unsigned side, double limit) {
    std::array<double, 8> beyond;  // of each corner
    bool cuts = false;
    for (int i = 0; i < polygon.count; ++i) {
        const Corner& corner = polygon.at(i);
        const double coordinate = side < 2 ? corner.u : corner.v;
        beyond[static_cast<std::size_t>(i)] = ((side & 1u) ? -coordinate : coordinate) - limit;
        cuts = cuts || beyond[static_cast<std::size_t>(i)] > 0.0;
    }
    if (!cuts) return;
    Polygon result;
    for (int i = 0; i < polygon.count; ++i) {
        const Corner& from = polygon.at(i);
        const Corner& to = polygon.at(i + 1);
        const double out_from = beyond[static_cast<std::size_t>(i)];
        const double out_to = beyond[static_cast<std::size_t>(i + 1 < polygon.count ? i + 1 : 0)];
        if (out_from <= 0.0) result.add(from);
        if ((out_from <= 0.0) == (out_to <= 0.0)) continue;
        Corner cut = between(from, to, out_from / (out_from - out_to));
        if (out_from <= 0.0) cut.edge = 4 + side;  // leaves here: the next edge runs along this side
        result.add(cut);
    }
    polygon = result;
}

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

    Polygon polygon;
    unsigned edge = 0;
    for (const Vector3& corner : {Vector3(p + q), Vector3(p - q), Vector3(-p - q), Vector3(q - p)}) {
        polygon.add({middle[0] + corner[0], middle[1] + corner[1], middle[2] + corner[2], edge++});
    }
    for (unsigned side = 0; side < 4 && polygon.count > 0; ++side) {
        clip(polygon, side, reference.half_size[side < 2 ? u_axis : v_axis] + tolerance);
    }

    manifold.normal = flipped ? Vector3(-normal) : normal;
    const unsigned faces = (flipped ? 64u : 0u) + face.label() * 8u + incident.label();
    for (int i = 0; i < polygon.count; ++i) {
        const Corner& corner = polygon.at(i);
        if (corner.height >= margin) continue;
        const unsigned before = polygon.at(i + polygon.count - 1).edge;
        const Vector3 position = centre + u * corner.u + v * corner.v + normal * (0.5 * corner.height);
        manifold.add({position, corner.height, (faces * 8u + before) * 8u + corner.edge});
    }
}

double sign_of(double value) {
    return value < 0.0 ? -1.0 : 1.0;
}

// Adds the point midway between the closest points of the two edges that face each other along the axis.
void cross_edges(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b, const Axis& axis,
                 Manifold& manifold) {
    const Vector3 edge_a = pose_a.rotation.col(axis.of_a);
    const Vector3 edge_b = pose_b.rotation.col(axis.of_b);
    Vector3 normal = edge_a.cross(edge_b).normalized();
    if (normal.dot(pose_b.position - pose_a.position) < 0.0) normal = -normal;

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

    // Closest points of the two lines.
    const Vector3 between_middles = corner_b - corner_a;
    const double along = edge_a.dot(edge_b);
    const double denominator = 1.0 - along * along;  // at least the square of `parallel_edges`
    const double s = (edge_a.dot(between_middles) - along * edge_b.dot(between_middles)) / denominator;
    const double t = (along * edge_a.dot(between_middles) - edge_b.dot(between_middles)) / denominator;
    // Where nearly parallel lines cross is decided by rounding; clamping keeps the point on both edges.
    const double half_a = a.half_size[axis.of_a], half_b = b.half_size[axis.of_b];
    const Vector3 on_a = corner_a + edge_a * std::clamp(s, -half_a, half_a);
    const Vector3 on_b = corner_b + edge_b * std::clamp(t, -half_b, half_b);

    manifold.normal = normal;
    const auto edges = static_cast<unsigned>(axis.of_a * 3 + axis.of_b);
    manifold.add({0.5 * (on_a + on_b), axis.separation, (1u << 16) + edges * 64u + which});
}

// Parameters of clipping the faces of both boxes.
struct Clipping {
    double tolerance;  // m, by which the reference face is widened
    double margin;     // m
};

void clip_to_face_of_a(const Box& a, const Pose& pose_a, int axis, const Box& b, const Pose& pose_b,
                       const Clipping& clipping, Manifold& manifold) {
    const Face face{axis, sign_of(pose_a.rotation.col(axis).dot(pose_b.position - pose_a.position))};
    clip_faces(a, pose_a, face, b, pose_b, false, clipping.tolerance, clipping.margin, manifold);
}

void clip_to_face_of_b(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b, int axis,
                       const Clipping& clipping, Manifold& manifold) {
    const Face face{axis, -sign_of(pose_b.rotation.col(axis).dot(pose_b.position - pose_a.position))};
    clip_faces(b, pose_b, face, a, pose_a, true, clipping.tolerance, clipping.margin, manifold);
}

// Largest separation along a face axis other than the manifold's normal.
double largest_of_others(const Axes& axes, const Pose& pose_a, const Pose& pose_b, double much,
                         const Vector3& normal) {
    double largest = -std::numeric_limits<double>::infinity();
    const auto consider = [&](double separation, const Matrix3& rotation, int axis) {
        if (separation < -much || separation <= largest) return;
        if (std::abs(rotation.col(axis).dot(normal)) < same_direction) largest = separation;
    };
    for (int i = 0; i < 3; ++i) {
        consider(axes.faces_a[static_cast<std::size_t>(i)], pose_a.rotation, i);
        consider(axes.faces_b[static_cast<std::size_t>(i)], pose_b.rotation, i);
    }
    return largest;
}

}  // namespace

void collide_box_box(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b, double margin,
                     Manifold& manifold) {
    const Axes axes = separate(a, pose_a, b, pose_b, margin);
    if (axes.largest() >= margin) return;

    const double size = size_of(a, b);
    const double preference = axis_preference * size;
    const Clipping clipping{clip_tolerance * size, margin};

    const double faces = std::max(axes.face_a.separation, axes.face_b.separation);
    if (axes.edges.separation > faces + preference) {
        cross_edges(a, pose_a, b, pose_b, axes.edges, manifold);
    } else if (axes.face_b.separation > axes.face_a.separation + preference) {
        clip_to_face_of_b(a, pose_a, b, pose_b, axes.face_b.of_b, clipping, manifold);
    } else {
        clip_to_face_of_a(a, pose_a, axes.face_a.of_a, b, pose_b, clipping, manifold);
    }
    const double much = 0.1 * std::max(a.half_size.minCoeff(), b.half_size.minCoeff());  // m of overlap
    manifold.other_gap = largest_of_others(axes, pose_a, pose_b, much, manifold.normal);
    manifold.separation = axes.largest();
}

void collide_box_box_along(const Separation& axis, const Box& a, const Pose& pose_a, const Box& b,
                           const Pose& pose_b, double room, double margin, Manifold& manifold) {
    manifold.count = 0;
    if (axis.gap >= margin) return;
    const Clipping clipping{std::max(room, clip_tolerance * size_of(a, b)), margin};
    if (axis.of_b < 0) {
        clip_to_face_of_a(a, pose_a, axis.of_a, b, pose_b, clipping, manifold);
    } else if (axis.of_a < 0) {
        clip_to_face_of_b(a, pose_a, b, pose_b, axis.of_b, clipping, manifold);
    } else {
        cross_edges(a, pose_a, b, pose_b, {axis.gap, axis.of_a, axis.of_b}, manifold);
    }
}

}  // namespace pushfactor::engine::collision
