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

Spread spread_of(std::span<const ContactPoint> points, const Vector3& u, const Vector3& v) {
    Vector3 middle = Vector3::Zero();
    for (const ContactPoint& point : points) middle += point.position / static_cast<int>(points.size());
    double uu = 0.0, uv = 0.0, vv = 0.0;
    for (const ContactPoint& point : points) {
        const double x = u.dot(point.position - middle), y = v.dot(point.position - middle);
        uu += x * x, uv += x * y, vv += y * y;
    }
    const double mean = 0.5 * (uu + vv), half = std::hypot(0.5 * (uu - vv), uv);
    return {std::sqrt(mean + half), std::sqrt(std::max(0.0, mean - half)), 0.5 * std::atan2(2.0 * uv, uu - vv)};
}

Outwards outwards(std::span<const ContactPoint> points, const Vector3& normal, const Matrix3& reference) {
    const Vector3 u = tangent_fixed_in(reference, normal);
    const Vector3 v = normal.cross(u);
    const Spread spread = spread_of(points, u, v);
    if (spread.length < long_ratio * spread.width) {
        const Vector3 direction = (2.0 * u + v).normalized();
        return {direction, normal.cross(direction)};
    }
    const Vector3 p = std::cos(spread.angle) * u + std::sin(spread.angle) * v;
    return off_diagonals(p * (spread.width / spread.length), normal.cross(p));
}

// Marks in `kept` the first and the last of `points` along `axis`, preferring deep ones.
void keep_ends(std::span<const ContactPoint> points, const Vector3& axis, std::span<bool> kept) {
    std::size_t first = 0, last = 0;
    double lowest = infinity, highest = -lowest;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const ContactPoint& point = points[i];
        const double along = axis.dot(point.position - points[0].position);
        if (along - point.gap > highest) highest = along - point.gap, last = i;
        if (along + point.gap < lowest) lowest = along + point.gap, first = i;
    }
    kept[first] = kept[last] = true;
}

// Most points that are chosen from: the corners of two faces.
constexpr std::size_t most_points = 1024;

// The order in which points of a rounded surface are chosen: the deepest layer, from which only the outermost are
// taken if it is enough, then the others by their height. Writes at most `most` of `points` to `chosen`, in their
// order, and returns how many.
std::size_t choose_by_layers(std::span<const ContactPoint> points, std::size_t most, const Outwards& directions,
                             double layer, std::span<ContactPoint> chosen) {
    std::array<bool, most_points> kept{};
    std::array<ContactPoint, most_points> lowest_layer;
    std::array<std::size_t, most_points> numbers{};
    double deepest = infinity;
    for (const ContactPoint& point : points) deepest = std::min(deepest, point.gap);
    std::size_t low = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i].gap > deepest + layer) continue;
        lowest_layer[low] = points[i];
        numbers[low++] = i;
    }
    if (low > most) {
        std::array<bool, most_points> ends{};
        const std::span<const ContactPoint> of_layer(lowest_layer.data(), low);
        keep_ends(of_layer, directions.along, ends);
        keep_ends(of_layer, directions.across, ends);
        if (most > 4) {
            keep_ends(of_layer, directions.along + directions.across, ends);
            keep_ends(of_layer, directions.along - directions.across, ends);
        }
        for (std::size_t k = 0; k < low; ++k) kept[numbers[k]] = ends[k];
    } else {
        for (std::size_t k = 0; k < low; ++k) kept[numbers[k]] = true;
        for (std::size_t filled = low; filled < std::min(most, points.size()); ++filled) {
            std::size_t next = points.size();
            for (std::size_t i = 0; i < points.size(); ++i) {
                if (!kept[i] && (next == points.size() || points[i].gap < points[next].gap)) next = i;
            }
            kept[next] = true;
        }
    }
    std::size_t count = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (kept[i]) chosen[count++] = points[i];
    }
    return count;
}

}  // namespace

void add_outermost(std::span<const ContactPoint> points, const Matrix3& reference, Manifold& manifold) {
    if (points.size() <= Manifold::max_points) {
        for (const ContactPoint& point : points) manifold.add(point);
        return;
    }
    const Outwards directions = outwards(points, manifold.normal, reference);
    manifold.count = static_cast<int>(
        choose_by_layers(points, Manifold::max_points, directions, manifold.layer, manifold.storage));
}

void reduce_to_four(Manifold& manifold, const Matrix3& reference) {
    if (manifold.count <= 4) return;
    const Outwards directions = outwards(manifold.points(), manifold.normal, reference);
    if (std::isfinite(manifold.layer)) {
        const auto all = manifold.storage;
        const std::span points(all.data(), static_cast<std::size_t>(manifold.count));
        manifold.count =
            static_cast<int>(choose_by_layers(points, 4, directions, manifold.layer, manifold.storage));
        return;
    }

    std::array<bool, Manifold::max_points> kept{};
    keep_ends(manifold.points(), directions.along, kept);
    keep_ends(manifold.points(), directions.across, kept);

    int count = 0;
    for (int i = 0; i < manifold.count; ++i) {
        const auto from = static_cast<std::size_t>(i);
        if (kept[from]) manifold.storage[static_cast<std::size_t>(count++)] = manifold.storage[from];
    }
    manifold.count = count;
}

}  // namespace pushfactor::engine::collision
