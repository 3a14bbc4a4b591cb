#include "engine/collision/manifold.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine::collision {

Vector3 tangent_fixed_in(const Matrix3& reference, const Vector3& normal) {
    // The x axis unless it nearly is the normal; not "the axis farthest from it", which rounding could flip
    // between two equally far ones.
    const Vector3 x = reference.col(0);
    const Vector3 axis = std::abs(x.dot(normal)) < 0.8 ? x : Vector3(reference.col(2));
    return (axis - normal * axis.dot(normal)).normalized();
}

void reduce_to_four(Manifold& manifold, const Matrix3& reference) {
    if (manifold.count <= 4) return;
    const Vector3 u = tangent_fixed_in(reference, manifold.normal);
    const Vector3 v = manifold.normal.cross(u);
    const Vector3 direction = (2.0 * u + v).normalized();
    const Vector3 across = manifold.normal.cross(direction);

    std::array<bool, Manifold::max_points> kept{};
    for (const Vector3& outward : {direction, across, Vector3(-direction), Vector3(-across)}) {
        const auto points = manifold.points();
        const auto reach = [&](const ContactPoint& p) { return outward.dot(p.position) - p.gap; };
        const auto outermost = std::max_element(points.begin(), points.end(),
                                                [&](const auto& p, const auto& q) { return reach(p) < reach(q); });
        kept[static_cast<std::size_t>(outermost - points.begin())] = true;
    }

    int count = 0;
    for (int i = 0; i < manifold.count; ++i) {
        const auto from = static_cast<std::size_t>(i);
        if (kept[from]) manifold.storage[static_cast<std::size_t>(count++)] = manifold.storage[from];
    }
    manifold.count = count;
}

}  // namespace pushfactor::engine::collision
