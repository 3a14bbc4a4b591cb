#include "demos/pictures/camera/framing.h"

#include <Eigen/Eigenvalues>

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

// The view turned about the vertical so that it looks across the motion, if that goes mostly one way: along it
// bodies would hide each other. The side and a part of the direction stay.
View across(const View& view, const std::vector<Ball>& places) {
    constexpr double one_way = 0.3;  // share of the shorter spread in the longer one
    constexpr double slant = 0.35;   // rad from straight across, for depth
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    const auto on_ground = [](const Vector3& point) { return Eigen::Vector2d(point.x(), point.z()); };
    for (const Ball& ball : places) mean += on_ground(ball.centre) / static_cast<double>(places.size());
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (const Ball& ball : places) {
        const Eigen::Vector2d away = on_ground(ball.centre) - mean;
        spread += away * away.transpose();
    }
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes;
    axes.computeDirect(spread);  // a closed form: the iteration for any size takes seconds to compile
    const Vector3 out = view.eye - view.target;
    if (std::sqrt(axes.eigenvalues()[0]) >= one_way * std::sqrt(axes.eigenvalues()[1])) return view;
    Eigen::Vector2d aside = axes.eigenvectors().col(0);
    if (aside.dot(on_ground(out)) < 0.0) aside = -aside;
    const auto angle_of = [](const Eigen::Vector2d& v) { return std::atan2(v.x(), v.y()); };
    const double turn = std::remainder(angle_of(aside) - angle_of(on_ground(out)), 2.0 * std::numbers::pi);
    if (std::abs(turn) <= slant) return view;
    View turned = view;
    turned.eye = view.target + Eigen::AngleAxisd(turn - std::copysign(slant, turn), Vector3::UnitY()) * out;
    return turned;
}

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

double reach_across(std::span<const Ball> balls, const View& view) {
    const Axes axes = axes_of(view);
    double reach = 0.0;
    for (const Ball& ball : balls) {
        const Vector3 offset = ball.centre - view.eye;
        const double depth = std::max(offset.dot(axes.forward), 1e-6);
        reach = std::max(reach, (std::abs(offset.dot(axes.right)) + ball.radius) / depth);
    }
    return reach;
}

Eigen::Vector2d place_in_picture(const Vector3& point, const View& view, double aspect) {
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

View overview(const View& view, const std::vector<Ball>& start, std::vector<Ball> reached, double aspect) {
    if (start.empty()) return view;
    const Eigen::AlignedBox3d near = surroundings(start);
    for (Ball& ball : reached) ball.centre = ball.centre.cwiseMax(near.min()).cwiseMin(near.max());
    reached.insert(reached.end(), start.begin(), start.end());
    return fitted(across(view, reached), reached, aspect);
}

std::vector<Ball> hull_of(const BodyDescription& body, const Vector3& position,
                          const engine::Quaternion& orientation) {
    std::vector<Ball> balls;
    const auto add = [&](const Vector3& corner) { balls.push_back({.centre = position + orientation * corner}); };
    std::visit(
        engine::Overloaded{
            [&](const BoxShape& box) {
                for (int corner = 0; corner < 8; ++corner) {
                    const Vector3 signs(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5);
                    add(signs.cwiseProduct(box.size));
                }
            },
            [&](const SphereShape& sphere) { balls.push_back({.centre = position, .radius = sphere.radius}); },
            [](const PlaneShape&) {},
            [&](const PolyhedronShape& polyhedron) { std::ranges::for_each(polyhedron.points(), add); }},
        body.shape);
    return balls;
}

std::vector<Ball> held_points(const BuiltScene& scene) {
    std::vector<Ball> points;
    each_held(scene, [&](const auto& held) {
        const auto [from, to] = span_of(held, scene.world.bodies);
        points.push_back({.centre = from});
        points.push_back({.centre = to});
    });
    return points;
}

std::vector<Ball> movable_balls(const BuiltScene& scene) {
    std::vector<Ball> balls;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        if (!goes_about(scene.bodies[i])) continue;
        balls.push_back({.centre = scene.world.bodies[i].position, .radius = bounding_radius(scene.bodies[i])});
    }
    const std::vector<Ball> held = held_points(scene);
    balls.insert(balls.end(), held.begin(), held.end());
    return balls;
}

Eigen::AlignedBox3d surroundings(std::span<const Ball> start) {
    Eigen::AlignedBox3d box;
    double radius = 0.0;
    for (const Ball& ball : start) {
        box.extend(ball.centre);
        radius = std::max(radius, ball.radius);
    }
    if (box.isEmpty()) return box;
    const Vector3 reach = Vector3::Constant(std::max(300.0 * radius, 10.0 * box.diagonal().norm()));
    return {box.min() - reach, box.max() + reach};
}

}  // namespace pushfactor::demos::pictures
