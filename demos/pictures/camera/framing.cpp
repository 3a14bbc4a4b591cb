#include "demos/pictures/camera/framing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace pushfactor::demos::pictures {

namespace {

using engine::Vector3;

constexpr double used = 0.90;  // share of the picture that the framed bodies may fill

// Bounds of the eye (x, z) along one axis of the picture: x - slope z >= low and x + slope z <= high keep all balls
// between the edges. The largest z forward is where both bounds are met.
struct Edges {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    double slope = 1.0;

    void hold(double x, double z, double radius) {
        const double beside = radius * std::hypot(1.0, slope);
        low = std::max(low, x + beside - slope * z);
        high = std::min(high, x - beside + slope * z);
    }
    double forward() const { return 0.5 * (high - low) / slope; }
    double middle() const { return 0.5 * (high + low); }
};

}  // namespace

Axes axes_of(const View& view) {
    const Vector3 forward = (view.target - view.eye).normalized();
    Vector3 right = forward.cross(Vector3::UnitY());
    right = right.norm() > 1e-3 ? right.normalized() : Vector3::UnitX();
    return {right, right.cross(forward), forward};
}

double distance_of(const View& view) {
    return (view.target - view.eye).norm();
}

double half_tangent(const View& view) {
    return std::tan(0.5 * view.field_of_view * std::numbers::pi / 180.0);
}

Reach reach_of(std::span<const Ball> balls, const View& view) {
    const Axes axes = axes_of(view);
    Reach reach;
    for (const Ball& ball : balls) {
        const Vector3 offset = ball.centre - view.eye;
        const double depth = std::max(offset.dot(axes.forward), 1e-6);
        reach.across = std::max(reach.across, (std::abs(offset.dot(axes.right)) + ball.radius) / depth);
        reach.up = std::max(reach.up, (std::abs(offset.dot(axes.up)) + ball.radius) / depth);
    }
    return reach;
}

Place place_in_picture(const Vector3& point, const View& view, double aspect) {
    const Axes axes = axes_of(view);
    const Vector3 offset = point - view.eye;
    const double reach = half_tangent(view) * offset.dot(axes.forward);
    return {0.5 + 0.5 * offset.dot(axes.right) / (reach * aspect), 0.5 - 0.5 * offset.dot(axes.up) / reach};
}

View fitted(const View& view, std::span<const Ball> balls, double aspect) {
    if (balls.empty()) return view;
    const Axes axes = axes_of(view);
    Edges sides{.slope = used * half_tangent(view) * aspect};
    Edges top{.slope = used * half_tangent(view)};
    double depth = 0.0, largest = 0.0, nearest = std::numeric_limits<double>::infinity();
    for (const Ball& ball : balls) {
        const double z = ball.centre.dot(axes.forward);
        sides.hold(ball.centre.dot(axes.right), z, ball.radius);
        top.hold(ball.centre.dot(axes.up), z, ball.radius);
        depth += z / static_cast<double>(balls.size());
        largest = std::max(largest, ball.radius);
        nearest = std::min(nearest, z - ball.radius);
    }
    const double forward =
        std::min({sides.forward(), top.forward(), depth - 2.0 * largest, nearest - 0.05 * (depth - nearest)});
    View fit = view;
    fit.eye = sides.middle() * axes.right + top.middle() * axes.up + forward * axes.forward;
    fit.target = fit.eye + (depth - forward) * axes.forward;
    return fit;
}

View widened(const View& view, double across, double aspect) {
    View wide = view;
    const double needed = std::atan(across / (used * aspect)) * 2.0 * 180.0 / std::numbers::pi;
    wide.field_of_view = std::clamp(needed, view.field_of_view, 120.0);
    return wide;
}

}  // namespace pushfactor::demos::pictures
