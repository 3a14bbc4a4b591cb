#include "engine/collision/manifold.h"

#include <algorithm>
#include <cmath>

namespace pushfactor::engine::collision {

Vector3 tangent_fixed_in(const Matrix3& reference, const Vector3& normal) {
    // The x axis unless it is nearly the normal; not "the axis farthest from it", which rounding could flip
    // between two equally far ones.
    const Vector3 x = reference.col(0);
    const Vector3 axis = std::abs(x.dot(normal)) < 0.8 ? x : Vector3(reference.col(2));
    return (axis - normal * axis.dot(normal)).normalized();
}

namespace {

// Ratio of length to width above which a manifold has a long direction; below it that direction is noise.
constexpr double long_ratio = 2.0;

// Two directions across the normal in which outermost points are searched. Their lengths differ for a long
// manifold and scale it to equal length and width.
struct Outwards {
    Vector3 along, across;
};

// `u` and `v` rotated and scaled so that the corners of a rectangle along them are distinguished by both
// directions, which lie off its diagonals.
Outwards off_diagonals(const Vector3& u, const Vector3& v) {
    return {(2.0 * u + v) / std::sqrt(5.0), (2.0 * v - u) / std::sqrt(5.0)};
}

// Square roots of the eigenvalues of the points' covariance in the plane of u and v [m], and the angle from u
// to the long direction.
struct Spread {
    double length, width, angle;
};

Spread spread_of(const Manifold& manifold, const Vector3& u, const Vector3& v) {
    Vector3 middle = Vector3::Zero();
    for (const ContactPoint& point : manifold.points()) middle += point.position / manifold.count;
    double uu = 0.0, uv = 0.0, vv = 0.0;
    for (const ContactPoint& point : manifold.points()) {
        const double x = u.dot(point.position - middle), y = v.dot(point.position - middle);
        uu += x * x, uv += x * y, vv += y * y;
    }
    const double mean = 0.5 * (uu + vv), half = std::hypot(0.5 * (uu - vv), uv);
    return {std::sqrt(mean + half), std::sqrt(std::max(0.0, mean - half)), 0.5 * std::atan2(2.0 * uv, uu - vv)};
}

Outwards outwards(const Manifold& manifold, const Matrix3& reference) {
    const Vector3 u = tangent_fixed_in(reference, manifold.normal);
    const Vector3 v = manifold.normal.cross(u);
    const Spread spread = spread_of(manifold, u, v);
    if (spread.length < long_ratio * spread.width) {
        const Vector3 direction = (2.0 * u + v).normalized();
        return {direction, manifold.normal.cross(direction)};
    }
    const Vector3 p = std::cos(spread.angle) * u + std::sin(spread.angle) * v;
    return off_diagonals(p * (spread.width / spread.length), manifold.normal.cross(p));
}

}  // namespace

void reduce_to_four(Manifold& manifold, const Matrix3& reference) {
    if (manifold.count <= 4) return;
    const Outwards directions = outwards(manifold, reference);

    std::array<bool, Manifold::max_points> kept{};
    for (const Vector3& axis : {directions.along, directions.across}) {
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
