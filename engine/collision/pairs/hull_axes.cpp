#include "engine/collision/pairs/hull_axes.h"

namespace pushfactor::engine::collision {

namespace {

const Vector3& support_vertex(const Hull& hull, const Vector3& direction) {
    return *std::ranges::max_element(hull.vertices, {}, [&](const Vector3& p) { return direction.dot(p); });
}

// The largest of n . w over the unit vectors n of the arc between the normals of an edge's faces. Inside the arc n
// is a sum of its ends with weights that add up to `bulge` at most.
double most_on_arc(const Hull& hull, const HullEdge& edge, const Vector3& w) {
    const double left = hull.face(edge.left).normal.dot(w), right = hull.face(edge.right).normal.dot(w);
    const auto [smaller, larger] = std::minmax(left, right);
    const double cosine = 2.0 / (edge.bulge * edge.bulge) - 1.0;  // between the ends
    return larger > 0.0 && smaller > cosine * larger ? larger * edge.bulge : larger;
}

}  // namespace

HullAxes::HullAxes(const PlacedHull& a, const PlacedHull& b)
    : a_(a),
      b_(b),
      turn_(a.pose().rotation.transpose() * b.pose().rotation),
      offset_(a.pose().rotation.transpose() * (b.pose().position - a.pose().position)),
      back_(-(turn_.transpose() * offset_)) {}

double HullAxes::along(const PlacedHull& own, int number) const {
    const HullFace& face = own.hull().face(number);
    const bool of_a = &own == &a_;
    const Vector3 to_other = of_a ? Vector3(turn_.transpose() * face.normal) : Vector3(turn_ * face.normal);
    return face.normal.dot(of_a ? offset_ : back_) - face.offset - support((of_a ? b_ : a_).hull(), -to_other);
}

double HullAxes::at_most_along(const PlacedHull& own, int number) const {
    const HullFace& face = own.hull().face(number);
    const bool of_a = &own == &a_;
    return face.normal.dot(of_a ? offset_ : back_) - face.offset - (of_a ? b_ : a_).hull().inner_radius;
}

double HullAxes::large_face_gap() const {
    double highest = -infinity;
    const PlacedHull* of = &a_;
    int face = 0;
    for (const PlacedHull* own : {&a_, &b_}) {
        for (int f = 0; f < static_cast<int>(own->hull().faces.size()); ++f) {
            const double bound = at_most_along(*own, f);
            if (bound > highest) highest = bound, of = own, face = f;
        }
    }
    return along(*of, face);
}

void HullAxes::list_edges(const Hull& own, const Hull& other, const Matrix3& turn, const Vector3& offset,
                          double least, EdgeList& list) {
    for (int number = 0; number < static_cast<int>(own.edges.size()); ++number) {
        const HullEdge& edge = own.edge(number);
        const Vector3 way = offset - own.vertex(edge.from);
        if (most_on_arc(own, edge, way) - other.inner_radius <= least) continue;
        const Vector3 middle = own.face(edge.left).normal + own.face(edge.right).normal;
        const Vector3 deepest = turn * support_vertex(other, -(turn.transpose() * middle));
        if (most_on_arc(own, edge, way + deepest) > least) list.add(number);
    }
}

HullAxes::EdgeOfB HullAxes::edge_of_b(int number) const {
    const HullEdge& edge = b_.hull().edge(number);
    return {.from = offset_ + turn_ * b_.hull().vertex(edge.from),
            .direction = turn_ * edge.direction,
            .against_left = -(turn_ * b_.hull().face(edge.left).normal),
            .against_right = -(turn_ * b_.hull().face(edge.right).normal)};
}

bool HullAxes::cross(int number_a, const EdgeOfB& edge_b, Vector3& normal, double& gap) const {
    const HullEdge& edge_a = a_.hull().edge(number_a);
    const Vector3& left = a_.hull().face(edge_a.left).normal;
    const Vector3& right = a_.hull().face(edge_a.right).normal;
    // Either arc has its ends on both sides of the plane of the other, and both arcs are on one half of the sphere.
    const double c = edge_b.against_left.dot(edge_a.direction), d = edge_b.against_right.dot(edge_a.direction);
    if (!(c * d < 0.0)) return false;
    const double p = left.dot(edge_b.direction), q = right.dot(edge_b.direction);
    if (!(p * q < 0.0) || !(c * q > 0.0)) return false;
    normal = edge_a.direction.cross(edge_b.direction);
    const double length = normal.norm();
    if (length < parallel_edges) return false;  // the adjacent faces cover this direction
    normal /= normal.dot(left + right) < 0.0 ? -length : length;
    gap = normal.dot(edge_b.from - a_.hull().vertex(edge_a.from));
    return true;
}

}  // namespace pushfactor::engine::collision
