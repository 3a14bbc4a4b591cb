#include "demos/pictures/outline.h"

#include "demos/pictures/draw_list.h"
#include "demos/pictures/plane_outline.h"
#include "engine/collision/polyhedron.h"
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

// Calls `add_point` with the corners of a body or `add_ball` with its centre and radius.
template <typename AddPoint, typename AddBall>
void visit_shape(const BodyDescription& described, const engine::Body& body, const AddPoint& add_point,
                 const AddBall& add_ball) {
    std::visit(
        engine::Overloaded{[&](const BoxShape& box) {
                               for (int corner = 0; corner < 8; ++corner) {
                                   const Vector3 signs((corner & 1) ? 0.5 : -0.5, (corner & 2) ? 0.5 : -0.5,
                                                       (corner & 4) ? 0.5 : -0.5);
                                   add_point(body.position + body.orientation * signs.cwiseProduct(box.size));
                               }
                           },
                           [&](const SphereShape& sphere) { add_ball(body.position, sphere.radius); },
                           [&](const PlaneShape&) {},
                           [&](const PolyhedronShape& polyhedron) {
                               for (const Vector3& vertex : polyhedron.mesh->hull().vertices) {
                                   add_point(body.position + body.orientation * vertex);
                               }
                           }},
        described.shape);
}

bool stands(const BodyDescription& described) {
    return !goes_about(described) && !std::holds_alternative<PlaneShape>(described.shape);
}

std::optional<double> ground_height(const BuiltScene& scene) {
    std::optional<double> height = scene.view.floor;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const engine::Body& body = scene.world.bodies[i];
        const bool level = (body.orientation * Vector3::UnitY()).y() > 0.9999;
        if (level && std::holds_alternative<PlaneShape>(scene.bodies[i].shape)) height = body.position.y();
    }
    return height;
}

}  // namespace

Outline::Outline() : farthest_(directions().size()) {}

void Outline::add(const Vector3& point) {
    for (std::size_t i = 0; i < farthest_.size(); ++i) {
        const double distance = directions()[i].dot(point);
        if (distance > farthest_[i].distance) farthest_[i] = {distance, point};
    }
}

void Outline::add_ball(const Vector3& centre, double radius) {
    for (std::size_t i = 0; i < farthest_.size(); ++i) {
        const double distance = directions()[i].dot(centre) + radius;
        if (distance > farthest_[i].distance) farthest_[i] = {distance, centre + radius * directions()[i]};
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

Eigen::AlignedBox3d surroundings(const BuiltScene& start) {
    Eigen::AlignedBox3d box;
    double radius = 0.0;
    for (std::size_t i = 0; i < start.bodies.size(); ++i) {
        if (!goes_about(start.bodies[i])) continue;
        box.extend(start.world.bodies[i].position);
        radius = std::max(radius, bounding_radius(start.bodies[i]));
    }
    if (box.isEmpty()) return box;
    const Vector3 reach = Vector3::Constant(std::max(300.0 * radius, 10.0 * box.diagonal().norm()));
    return {box.min() - reach, box.max() + reach};
}

void add_moving(const BuiltScene& scene, const Eigen::AlignedBox3d& near, Outline& outline) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        if (!goes_about(scene.bodies[i])) continue;
        visit_shape(
            scene.bodies[i], scene.world.bodies[i],
            [&](const Vector3& point) { outline.add(clamped(point, near)); },
            [&](const Vector3& centre, double radius) { outline.add_ball(clamped(centre, near), radius); });
    }
    const auto add_ends = [&](const auto& held) {
        const auto [from, to] = span_of(held, scene.world.bodies);
        outline.add(clamped(from, near));
        outline.add(clamped(to, near));
    };
    if (scene.distances) std::ranges::for_each(scene.distances->distances(), add_ends);
    if (scene.joints) std::ranges::for_each(scene.joints->joints(), add_ends);
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
        const auto add = [&](const Vector3& point) { outline.add(clamped(point, around(beside))); };
        if (stands(scene.bodies[i])) {
            visit_shape(scene.bodies[i], body, add, [&](const Vector3& centre, double radius) {
                for (const Vector3& direction : directions()) add(centre + radius * direction);
            });
        } else if (std::holds_alternative<PlaneShape>(scene.bodies[i].shape)) {
            const bool level = (body.orientation * Vector3::UnitY()).y() > 0.9999;
            if (level) continue;
            for (const Vector3& corner : plane_outline(scene, body)) outline.add(clamped(corner, around(wall)));
        }
    }
}

Subject subject_of(const BuiltScene& scene, const Outline& outline) {
    const std::optional<double> ground = ground_height(scene);
    Subject subject{.points = outline.points(), .shadow = {}};
    if (!ground) return subject;
    const glm::vec3 sun = renderer::Picture{}.towards_sun;
    const Vector3 towards_sun(sun.x, sun.y, sun.z);
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
