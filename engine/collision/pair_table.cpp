#include "engine/collision/pair_table.h"

#include "engine/collision/box_box.h"
#include "engine/collision/box_plane.h"
#include "engine/collision/sphere_pairs.h"

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

constexpr Collide box_box = of<Box, Box, collide_box_box>;
constexpr Collide box_plane = of<Box, Plane, collide_box_plane>;
constexpr Collide plane_box = swapped<box_plane>;
constexpr Collide box_sphere = of<Box, Sphere, collide_box_sphere>;
constexpr Collide sphere_box = swapped<box_sphere>;
constexpr Collide sphere_sphere = of<Sphere, Sphere, collide_sphere_sphere>;
constexpr Collide sphere_plane = of<Sphere, Plane, collide_sphere_plane>;
constexpr Collide plane_sphere = swapped<sphere_plane>;
constexpr Collide never = nullptr;  // planes are always static

// Row: shape of a, column: shape of b, in the order of the variant.
// clang-format off
constexpr std::array<std::array<Collide, 3>, 3> pair_table{{
    //             box         sphere         plane
    /* box    */ {{box_box,    box_sphere,    box_plane}},
    /* sphere */ {{sphere_box, sphere_sphere, sphere_plane}},
    /* plane  */ {{plane_box,  plane_sphere,  never}},
}};
// clang-format on
static_assert(pair_table.size() == std::variant_size_v<Shape>, "a shape without a row in the table");

}  // namespace

void collide(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, double margin,
             Manifold& manifold) {
    manifold.count = 0;
    manifold.other_gap = -std::numeric_limits<double>::infinity();
    manifold.separation = std::numeric_limits<double>::infinity();
    if (const Collide function = pair_table[a.index()][b.index()]) {
        function(a, pose_a, b, pose_b, margin, manifold);
    }
}

}  // namespace pushfactor::engine::collision
