#include "engine/collision/pairs/pair_table.h"

#include "engine/collision/pairs/box_box.h"
#include "engine/collision/pairs/box_plane.h"
#include "engine/collision/pairs/polyhedron_pairs.h"
#include "engine/collision/pairs/sphere_pairs.h"

#include <array>

namespace pushfactor::engine::collision {

namespace {

using Collide = void (*)(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, double margin,
                         Manifold& manifold);

// Adapter for a function of two concrete shapes.
template <typename A, typename B, void (*function)(const A&, const Pose&, const B&, const Pose&, double, Manifold&)>
void of(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, double margin, Manifold& manifold) {
    function(std::get<A>(a), pose_a, std::get<B>(b), pose_b, margin, manifold);
}

// The same pair in reverse order: swapped arguments, opposite normal.
template <Collide function>
void swapped(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, double margin,
             Manifold& manifold) {
    function(b, pose_b, a, pose_a, margin, manifold);
    manifold.normal = -manifold.normal;
}

// A polyhedron with a polyhedron or a box.
template <typename A, typename B>
void hulls(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, double margin,
           Manifold& manifold) {
    collide_hulls(PlacedHull(std::get<A>(a), pose_a), PlacedHull(std::get<B>(b), pose_b), margin, manifold);
}

constexpr Collide box_box = of<Box, Box, collide_box_box>;
constexpr Collide box_plane = of<Box, Plane, collide_box_plane>;
constexpr Collide plane_box = swapped<box_plane>;
constexpr Collide box_sphere = of<Box, Sphere, collide_box_sphere>;
constexpr Collide sphere_box = swapped<box_sphere>;
constexpr Collide sphere_sphere = of<Sphere, Sphere, collide_sphere_sphere>;
constexpr Collide sphere_plane = of<Sphere, Plane, collide_sphere_plane>;
constexpr Collide plane_sphere = swapped<sphere_plane>;
constexpr Collide poly_poly = hulls<Polyhedron, Polyhedron>;
constexpr Collide poly_box = hulls<Polyhedron, Box>;
constexpr Collide box_poly = hulls<Box, Polyhedron>;
constexpr Collide poly_sphere = of<Polyhedron, Sphere, collide_polyhedron_sphere>;
constexpr Collide sphere_poly = swapped<poly_sphere>;
constexpr Collide poly_plane = of<Polyhedron, Plane, collide_polyhedron_plane>;
constexpr Collide plane_poly = swapped<poly_plane>;
constexpr Collide static_pair = nullptr;  // planes are always static

// Row: shape of a, column: shape of b, in the order of the variant.
// clang-format off
constexpr std::array<std::array<Collide, 4>, 4> pair_table{{
    //                 box         sphere         plane         polyhedron
    /* box        */ {{box_box,    box_sphere,    box_plane,    box_poly}},
    /* sphere     */ {{sphere_box, sphere_sphere, sphere_plane, sphere_poly}},
    /* plane      */ {{plane_box,  plane_sphere,  static_pair,        plane_poly}},
    /* polyhedron */ {{poly_box,   poly_sphere,   poly_plane,   poly_poly}},
}};
// clang-format on
static_assert(pair_table.size() == std::variant_size_v<Shape>, "a shape without a row in the table");

}  // namespace

void collide(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, double margin,
             Manifold& manifold) {
    manifold.count = 0;
    manifold.other_gap = -infinity;
    manifold.separation = infinity;
    manifold.rounded = false;
    if (const Collide function = pair_table[a.index()][b.index()]) {
        function(a, pose_a, b, pose_b, margin, manifold);
    }
}

}  // namespace pushfactor::engine::collision
