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
    for (const Vector3& axis : {direction, across}) {
        std::size_t first = 0, last = 0;
        double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
        for (std::size_t i = 0; i < manifold.points().size(); ++i) {
            const ContactPoint& point = manifold.storage[i];
            const double along = axis.dot(point.position - manifold.storage[0].position);
            if (along - point.gap > highest) highest = along - point.gap, last = i;
            if (along + point.gap < lowest) lowest = along + point.gap, first = i;
        }
        kept[first] = kept[last] = true;
    }

    int count = 0;
    for (int i = 0; i < manifold.count; ++i) {
        const auto from = static_cast<std::size_t>(i);
        if (kept[from]) manifold.storage[static_cast<std::size_t>(count++)] = manifold.storage[from];
    }
    manifold.count = count;
}

}  // namespace pushfactor::engine::collision
