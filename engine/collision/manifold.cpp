#include "engine/collision/manifold.h"

#include "engine/base/constants.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pushfactor::engine::collision {

Vector3 tangent_fixed_in(const Matrix3& reference, const Vector3& normal) {
    // The x axis unless it is nearly the normal; not "the axis farthest from it", which rounding could flip
    // between two equally far ones.
    const Vector3 x = reference.col(0);
    const Vector3 axis = std::abs(x.dot(normal)) < 0.8 ? x : Vector3(reference.col(2));
    return (axis - normal * axis.dot(normal)).normalized();
}

namespace {

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

Spread spread_of(std::span<const ContactPoint> points, const Vector3& u, const Vector3& v) {
    Vector3 middle = Vector3::Zero();
    for (const ContactPoint& point : points) middle += point.position / static_cast<int>(points.size());
    double uu = 0.0, uv = 0.0, vv = 0.0;
    for (const ContactPoint& point : points) {
        const double x = u.dot(point.position - middle), y = v.dot(point.position - middle);
        uu += x * x, uv += x * y, vv += y * y;
    }
    const double mean = 0.5 * (uu + vv), half = elementary::hypot(0.5 * (uu - vv), uv);
    return {std::sqrt(mean + half), std::sqrt(std::max(0.0, mean - half)),
            0.5 * elementary::atan2(2.0 * uv, uu - vv)};
}

Outwards outwards_of(std::span<const ContactPoint> points, const Vector3& normal, const Matrix3& reference) {
    const Vector3 u = tangent_fixed_in(reference, normal);
    const Vector3 v = normal.cross(u);
    const Spread spread = spread_of(points, u, v);
    if (spread.length < constants::collision::long_ratio * spread.width) {
        const Vector3 direction = (2.0 * u + v).normalized();
        return {direction, normal.cross(direction)};
    }
    const Vector3 p = elementary::cos(spread.angle) * u + elementary::sin(spread.angle) * v;
    return off_diagonals(p * (spread.width / spread.length), normal.cross(p));
}

// The point that is deepest after a turn that lifts each by its way along `slope`, of those that are not `kept`
// yet.
std::size_t deepest(std::span<const ContactPoint> points, std::span<const double> ends, const Vector3& slope,
                    std::span<const bool> kept) {
    std::size_t deepest = 0;
    double lowest = infinity;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (kept[i]) continue;
        const double height = ends[i] + slope.dot(points[i].position - points[0].position);
        if (height < lowest) lowest = height, deepest = i;
    }
    return deepest;
}

// Slope of the turn, at most 1.
double slope_of(const Turning& turning, std::span<const ContactPoint> points) {
    double square = 0.0;
    for (const ContactPoint& point : points) {
        square = std::max(square, (point.position - points[0].position).squaredNorm());
    }
    const double rise = turning.path + turning.room, half = 0.5 * std::sqrt(square);
    return rise < half ? rise / half : 1.0;
}

// Directions around the normal so that a corner midway between two of them sinks by no more than `allowed` where
// the shapes turn by `path`.
int directions_for(const Turning& turning, int least, int most) {
    int directions = least;
    const auto sinks = [&](int n) { return turning.path * (1.0 - elementary::cos(std::numbers::pi / n)); };
    while (directions < most && sinks(directions) > turning.allowed) directions *= 2;
    return directions;
}

}  // namespace

void keep_carrying(const Turning& turning, const Matrix3& reference, int least, int most, Manifold& manifold) {
    const int directions = directions_for(turning, least, most);
    if (manifold.count <= directions) return;
    const std::span<ContactPoint> points = manifold.points();
    const Outwards outwards = outwards_of(points, manifold.normal, reference);
    const double slope = manifold.rounded ? slope_of(turning, points) : 1.0;

    std::array<bool, Manifold::most_points> kept;
    std::fill_n(kept.begin(), points.size(), false);
    for (int k = 0; k < directions; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / directions;
        const Vector3 uphill = elementary::cos(angle) * outwards.along + elementary::sin(angle) * outwards.across;
        kept[deepest(points, turning.ends, slope * uphill, kept)] = true;
    }
    int count = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (kept[i]) points[static_cast<std::size_t>(count++)] = points[i];
    }
    manifold.count = count;
}

}  // namespace pushfactor::engine::collision
