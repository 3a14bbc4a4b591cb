#include "demos/pictures/camera/outline.h"

#include "demos/pictures/draw_list.h"
#include "demos/pictures/to_glm.h"
#include "renderer/picture/picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace pushfactor::demos::pictures {

namespace {

using engine::Vector3;

// Evenly over the sphere, 14 degrees apart.
const std::vector<Vector3>& directions() {
    static const std::vector<Vector3> all = [] {
        constexpr int count = 200;
        std::vector<Vector3> list;
        for (int i = 0; i < count; ++i) {
            const double y = 1.0 - 2.0 * (i + 0.5) / count;
            const double turn = 2.0 * std::numbers::pi * i / std::numbers::phi;
            const double level = std::sqrt(1.0 - y * y);
            list.emplace_back(level * std::cos(turn), y, level * std::sin(turn));
        }
        return list;
    }();
    return all;
}

Eigen::AlignedBox3d box_of(std::span<const Vector3> points) {
    Eigen::AlignedBox3d box;
    for (const Vector3& point : points) box.extend(point);
    return box;
}

Vector3 clamped(const Vector3& point, const Eigen::AlignedBox3d& box) {
    return point.cwiseMax(box.min()).cwiseMin(box.max());
}

// Points whose hull is the ball.
std::vector<Vector3> points_of(const Ball& ball) {
    if (ball.radius == 0.0) return {ball.centre};
    std::vector<Vector3> points;
    for (const Vector3& direction : directions()) points.push_back(ball.centre + ball.radius * direction);
    return points;
}

constexpr double degrees = std::numbers::pi / 180.0;
constexpr double highest = 60.0;  // degrees above the horizon that the camera is raised to
constexpr double margin = 0.05;   // share of the picture at each side that stays free
constexpr double most = 0.12;     // share of the picture's width that the subject is moved aside

// The view from another side of its target: turned to the right and raised, in degrees.
View moved_around(const View& view, double turn, double raise) {
    const Vector3 from = view.eye - view.target;
    const double level = std::hypot(from.x(), from.z());
    const double elevation = std::atan2(from.y(), level);
    const double azimuth = std::atan2(from.x(), from.z()) + turn * degrees;
    const double raised = std::max(elevation, std::min(elevation + raise * degrees, highest * degrees));
    View moved = view;
    moved.eye = view.target + from.norm() * Vector3(std::cos(raised) * std::sin(azimuth), std::sin(raised),
                                                    std::cos(raised) * std::cos(azimuth));
    return moved;
}

// Moves the camera sideways, so that subject and shadow together are in the middle, as far as the subject stays in
// the picture.
View balanced(const View& view, const Subject& subject, double aspect) {
    const Eigen::AlignedBox2d own = extent_of(subject.points, view, aspect);
    const Eigen::AlignedBox2d thrown = extent_of(subject.shadow, view, aspect);
    const double own_left = own.min().x(), own_right = own.max().x(), height = own.sizes().y();
    const double left = std::min(own_left, std::max(thrown.min().x(), own_left - height));
    const double right = std::max(own_right, std::min(thrown.max().x(), own_right + height));
    // Positive to the right: the subject then goes to the left.
    const double wanted = 0.5 * (left + right) - 0.5;
    const double most_right = std::clamp(0.45 * (own_left - margin), 0.0, most);
    const double most_left = std::clamp(0.45 * (own_right - 1.0 + margin), -most, 0.0);
    const double shift = std::clamp(wanted, most_left, most_right);
    const Vector3 forward = view.target - view.eye;
    const Vector3 right_hand = forward.cross(Vector3::UnitY());
    if (right_hand.norm() < 1e-3 * forward.norm()) return view;
    const Vector3 offset = 2.0 * shift * half_tangent(view) * aspect * forward.norm() * right_hand.normalized();
    View moved = view;
    moved.eye += offset;
    moved.target += offset;
    return moved;
}

}  // namespace

Outline::Outline() : farthest_(directions().size()) {}

void Outline::add(const Ball& ball) {
    for (std::size_t i = 0; i < farthest_.size(); ++i) {
        const double distance = directions()[i].dot(ball.centre) + ball.radius;
        if (distance > farthest_[i].distance) {
            farthest_[i] = {distance, ball.centre + ball.radius * directions()[i]};
        }
    }
}

void Outline::add(const Outline& other) {
    for (std::size_t i = 0; i < farthest_.size(); ++i) {
        if (other.farthest_[i].distance > farthest_[i].distance) farthest_[i] = other.farthest_[i];
    }
}

std::vector<Vector3> Outline::points() const {
    std::vector<Vector3> points;
    if (empty()) return points;
    for (const Farthest& farthest : farthest_) {
        const bool known = std::ranges::find(points, farthest.point) != points.end();
        if (!known) points.push_back(farthest.point);
    }
    return points;
}

void add_moving(const BuiltScene& scene, const Eigen::AlignedBox3d& near, Outline& outline) {
    const auto add = [&](const Ball& ball) { outline.add({clamped(ball.centre, near), ball.radius}); };
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const engine::Body& body = scene.world.bodies[i];
        if (!goes_about(scene.bodies[i])) continue;
        std::ranges::for_each(hull_of(scene.bodies[i], body.position, body.orientation), add);
    }
    std::ranges::for_each(held_points(scene), add);
}

void add_support(const BuiltScene& scene, Outline& outline) {
    // So much of its size around the subject, for bodies and for walls.
    constexpr double beside = 0.25, wall = 0.5;
    const Eigen::AlignedBox3d subject = box_of(outline.points());
    const auto around = [&](double share) {
        if (subject.isEmpty()) return Eigen::AlignedBox3d(Vector3::Constant(-1e6), Vector3::Constant(1e6));
        const Vector3 reach = Vector3::Constant(share * subject.sizes().maxCoeff());
        return Eigen::AlignedBox3d(subject.min() - reach, subject.max() + reach);
    };
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const engine::Body& body = scene.world.bodies[i];
        const auto add = [&](const Vector3& point, double share) {
            outline.add({clamped(point, around(share)), 0.0});
        };
        if (std::holds_alternative<PlaneShape>(scene.bodies[i].shape) && !is_level(body)) {
            for (const Vector3& corner : plane_outline(scene, body)) add(corner, wall);
        }
        if (goes_about(scene.bodies[i])) continue;
        for (const Ball& ball : hull_of(scene.bodies[i], body.position, body.orientation)) {
            for (const Vector3& point : points_of(ball)) add(point, beside);
        }
    }
}

Subject subject_of(const BuiltScene& scene, const Outline& outline) {
    const std::optional<double> ground = ground_height(scene);
    Subject subject{.points = outline.points(), .shadow = {}};
    if (!ground) return subject;
    const Vector3 towards_sun = to_eigen(renderer::Picture{}.towards_sun);
    for (const Vector3& point : subject.points) {
        const double height = std::max(point.y() - *ground, 0.0);
        subject.shadow.push_back(point - height / towards_sun.y() * towards_sun);
    }
    return subject;
}

Subject with_room(Subject subject, double above, double below) {
    const Eigen::AlignedBox3d box = box_of(subject.points);
    if (box.isEmpty()) return subject;
    const double height = box.sizes().y();
    const std::vector<Vector3> own = subject.points;
    for (const Vector3& point : own) {
        if (above > 0.0) subject.points.push_back(point + above * height * Vector3::UnitY());
        if (below > 0.0) subject.points.push_back(point - below * height * Vector3::UnitY());
    }
    return subject;
}

Eigen::AlignedBox2d extent_of(std::span<const Vector3> points, const View& view, double aspect) {
    Eigen::AlignedBox2d extent;
    for (const Vector3& point : points) extent.extend(place_in_picture(point, view, aspect));
    return extent;
}

View composed(const View& view, const Subject& subject, double aspect) {
    if (subject.points.empty()) return view;
    std::vector<Ball> points;
    for (const Vector3& point : subject.points) points.push_back({.centre = point});
    View best = view;
    double highest_worth = -1.0;
    for (const double raise : {0.0, 10.0, 20.0}) {
        for (const double turn : {0.0, -15.0, 15.0, -30.0, 30.0, -45.0, 45.0}) {
            const View fit = fitted(moved_around(view, turn, raise), points, aspect);
            const Eigen::Vector2d extent = extent_of(subject.points, fit, aspect).sizes();
            // Another side than the scene's has to be worth it.
            const double worth = std::sqrt(extent.prod()) * (1.0 - 0.005 * std::abs(turn) - 0.006 * raise);
            if (worth <= highest_worth + 1e-9) continue;
            highest_worth = worth;
            best = fit;
        }
    }
    return subject.shadow.empty() ? best : balanced(best, subject, aspect);
}

}  // namespace pushfactor::demos::pictures
