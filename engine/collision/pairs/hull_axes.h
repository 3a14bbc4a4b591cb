// Separating axes of two convex polyhedra (paper section 4): their face normals, and the cross products of two
// edges whose arcs cross on the Gauss map. The other pairs of edges do not support the polyhedra on both sides of
// their common plane (Gregorius 2013, "The separating axis test between convex polyhedra").
//
// Axes that cannot matter are left out by bounds: a polyhedron reaches at least as far as the ball in it, and as
// any point of it.
#pragma once

#include "engine/collision/pairs/placed_hull.h"
#include "engine/collision/pairs/separations.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pushfactor::engine::collision {

class HullAxes {
  public:
    HullAxes(const PlacedHull& a, const PlacedHull& b);

    // The gap along one of the face axes, probably one of the largest [m].
    double large_face_gap() const;

    // Calls `visit` with the face axes of which the gap may reach `least` [m].
    template <typename Visit>
    void visit_faces(double least, const Visit& visit) const {
        for (const PlacedHull* own : {&a_, &b_}) {
            for (int f = 0; f < static_cast<int>(own->hull().faces.size()); ++f) {
                if (at_most_along(*own, f) < least) continue;
                const Vector3 out = own->pose().rotation * own->hull().face(f).normal;
                if (own == &a_) {
                    visit(Separation{out, along(a_, f), f, -1});
                } else {
                    visit(Separation{-out, along(b_, f), -1, f});
                }
            }
        }
    }

    // Calls `visit` with the axes of two edges of which the gap exceeds `least` [m]. Edges that are parallel up to
    // `parallel_edges` have none.
    template <typename Visit>
    void visit_edges(double least, const Visit& visit) const {
        EdgeList of_a, of_b;
        list_edges(a_.hull(), b_.hull(), turn_, offset_, least, of_a);
        if (of_a.count == 0) return;
        list_edges(b_.hull(), a_.hull(), turn_.transpose(), back_, least, of_b);
        for (int j = 0; j < of_b.count; ++j) {
            const int number_b = of_b.numbers[static_cast<std::size_t>(j)];
            const EdgeOfB edge_b = edge_of_b(number_b);
            for (int i = 0; i < of_a.count; ++i) {
                const int number_a = of_a.numbers[static_cast<std::size_t>(i)];
                Vector3 normal;  // in the frame of a
                double gap = 0.0;
                if (!cross(number_a, edge_b, normal, gap) || gap <= least) continue;
                visit(Separation{a_.pose().rotation * normal, gap, number_a, number_b});
            }
        }
    }

  private:
    // Separation along the normal of a face of one of both, and an upper bound of it [m].
    double along(const PlacedHull& own, int face) const;
    double at_most_along(const PlacedHull& own, int face) const;

    static constexpr std::size_t most_edges = 3 * most_vertices;
    struct EdgeList {
        std::array<int, most_edges> numbers;
        int count = 0;
        EdgeList() {}  // NOLINT(modernize-use-equals-default): the numbers stay uninitialised
        void add(int number) { numbers[static_cast<std::size_t>(count++)] = number; }
    };
    // In the frame of a.
    struct EdgeOfB {
        Vector3 from, direction;
        Vector3 against_left, against_right;  // normals of its faces, reversed
    };

    // Those of `own` of which an axis may have more than `least` [m]. `turn`: from the frame of the other to its
    // own; `offset` [m]: origin of the other in its own frame.
    static void list_edges(const Hull& own, const Hull& other, const Matrix3& turn, const Vector3& offset,
                           double least, EdgeList& list);
    EdgeOfB edge_of_b(int number) const;
    // Whether the arcs of the two edges cross; then the axis from a to b and the gap along it.
    bool cross(int number_a, const EdgeOfB& edge_b, Vector3& normal, double& gap) const;

    const PlacedHull& a_;
    const PlacedHull& b_;
    Matrix3 turn_;    // from the frame of b to that of a
    Vector3 offset_;  // m, origin of b in the frame of a
    Vector3 back_;    // m, origin of a in the frame of b
};

// Calls `visit` with the separations of two polyhedra of which the gap exceeds `least` [m], perhaps with some
// others, and at least with the largest.
template <typename Visit>
void visit_separations(const PlacedHull& a, const PlacedHull& b, double least, const Visit& visit) {
    const HullAxes axes(a, b);
    double largest = -infinity;
    axes.visit_faces(std::min(least, axes.large_face_gap()), [&](const Separation& separation) {
        largest = std::max(largest, separation.gap);
        visit(separation);
    });
    axes.visit_edges(std::min(least, largest), visit);
}

}  // namespace pushfactor::engine::collision
