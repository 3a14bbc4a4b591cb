#include "engine/collision/pairs/collide.h"

#include "engine/base/overloaded.h"
#include "engine/collision/pairs/pairs.h"

namespace pushfactor::engine::collision {

void collide(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, double margin,
             Manifold& manifold) {
    manifold.count = 0;
    manifold.other_gap = -infinity;
    manifold.separation = infinity;
    manifold.rounded = false;
    const auto turn_around = [&] { manifold.normal = -manifold.normal; };
    std::visit(
        Overloaded{
            [&](const Box& p, const Box& q) { collide_box_box(p, pose_a, q, pose_b, margin, manifold); },
            [&](const Flat auto& p, const Flat auto& q) {
                collide_hulls(PlacedHull(p, pose_a), PlacedHull(q, pose_b), margin, manifold);
            },
            [&](const auto& p, const Sphere& q) { collide_with_sphere(p, pose_a, q, pose_b, margin, manifold); },
            [&](const Sphere& p, const Flat auto& q) {
                collide_with_sphere(q, pose_b, p, pose_a, margin, manifold);
                turn_around();
            },
            [&](const auto& p, const Plane&) { collide_with_plane(p, pose_a, pose_b, margin, manifold); },
            [&](const Plane&, const auto& q) {
                collide_with_plane(q, pose_b, pose_a, margin, manifold);
                turn_around();
            },
            [&](const Plane&, const Sphere& q) {
                collide_with_plane(q, pose_b, pose_a, margin, manifold);
                turn_around();
            },
            [](const Plane&, const Plane&) {}},  // both are static
        a, b);
}

void collide_along(const Vector3& normal, const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b,
                   double margin, Manifold& manifold) {
    manifold.count = 0;
    std::visit(
        Overloaded{[&](const Flat auto& p, const Flat auto& q) {
                       collide_hulls_along(normal, PlacedHull(p, pose_a), PlacedHull(q, pose_b), margin, manifold);
                   },
                   [&](const Flat auto& p, const Sphere& q) {
                       collide_hull_sphere_along(normal, PlacedHull(p, pose_a), q, pose_b, margin, manifold);
                   },
                   [&](const Sphere& p, const Flat auto& q) {
                       collide_hull_sphere_along(-normal, PlacedHull(q, pose_b), p, pose_a, margin, manifold);
                   },
                   [](const auto&, const auto&) {}},
        a, b);
    manifold.normal = normal;
}

}  // namespace pushfactor::engine::collision
