#include "demos/pictures/camera/outline.h"

#include "demos/pictures/camera/framing.h"
#include "demos/pictures/camera/plane_outline.h"
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

Eigen::AlignedBox3d Outline::box() const {
    Eigen::AlignedBox3d box;
    for (const Vector3& point : points()) box.extend(point);
    return box;
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
    const Eigen::AlignedBox3d subject = outline.box();
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
    Eigen::AlignedBox3d box;
    for (const Vector3& point : subject.points) box.extend(point);
    if (box.isEmpty()) return subject;
    const double height = box.sizes().y();
    const std::vector<Vector3> own = subject.points;
    for (const Vector3& point : own) {
        if (above > 0.0) subject.points.push_back(point + above * height * Vector3::UnitY());
        if (below > 0.0) subject.points.push_back(point - below * height * Vector3::UnitY());
    }
    return subject;
}

}  // namespace pushfactor::demos::pictures
