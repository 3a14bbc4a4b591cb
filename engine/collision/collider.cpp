#include "engine/collision/collider.h"

#include "engine/base/overloaded.h"

namespace pushfactor::engine::collision {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

Pose pose_of(const Body& body) {
    return {body.position, body.orientation.toRotationMatrix()};
}

bool runs_at(const Collider& collider, double time) {
    const double rounding = 1e-9 * time;  // the world's time is a sum of steps
    return !collider.surface_velocity.isZero(0.0) && time >= collider.surface_from - rounding;
}

double size_of(const Shape& shape) {
    return std::visit(
        Overloaded{[](const Box& box) { return 2.0 * box.half_size.minCoeff(); },
                   [](const Sphere& sphere) { return 2.0 * sphere.radius; }, [](const Plane&) { return infinity; }},
        shape);
}

Vector3 half_extents(const Shape& shape, const Matrix3& rotation) {
    return std::visit(Overloaded{[&](const Box& box) -> Vector3 { return rotation.cwiseAbs() * box.half_size; },
                                 [](const Sphere& sphere) -> Vector3 { return Vector3::Constant(sphere.radius); },
                                 [](const Plane&) -> Vector3 { return Vector3::Constant(infinity); }},
                      shape);
}

double reach_along(const Shape& shape, const Matrix3& rotation, const Vector3& direction) {
    return std::visit(
        Overloaded{[&](const Box& box) { return (rotation.transpose() * direction).cwiseAbs().dot(box.half_size); },
                   [&](const Sphere& sphere) { return sphere.radius * direction.norm(); },
                   [](const Plane&) { return infinity; }},
        shape);
}

double squared_turning_radius(const Shape& shape) {
    return std::visit(Overloaded{[](const Box& box) { return box.half_size.squaredNorm(); },
                                 [](const Sphere&) { return 0.0; }, [](const Plane&) { return 0.0; }},
                      shape);
}

bool turns_in_itself(const Shape& shape) {
    return std::visit(Overloaded{[](const Box&) { return false; }, [](const Sphere&) { return true; },
                                 [](const Plane&) { return false; }},
                      shape);
}

bool is_finite(const Shape& shape) {
    return std::visit(Overloaded{[](const Box&) { return true; }, [](const Sphere&) { return true; },
                                 [](const Plane&) { return false; }},
                      shape);
}

}  // namespace pushfactor::engine::collision
