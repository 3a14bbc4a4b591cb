#include "engine/collision/collider.h"

#include "engine/base/overloaded.h"

namespace pushfactor::engine::collision {

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
                   [](const Sphere& sphere) { return 2.0 * sphere.radius; }, [](const Plane&) { return infinity; },
                   [](const Polyhedron& polyhedron) { return polyhedron.mesh->hull().size; }},
        shape);
}

Vector3 half_extents(const Shape& shape, const Matrix3& rotation) {
    return std::visit(Overloaded{[&](const Box& box) -> Vector3 { return rotation.cwiseAbs() * box.half_size; },
                                 [](const Sphere& sphere) -> Vector3 { return Vector3::Constant(sphere.radius); },
                                 [](const Plane&) -> Vector3 { return Vector3::Constant(infinity); },
                                 [&](const Polyhedron& polyhedron) {
                                     Vector3 reach = Vector3::Zero();
                                     for (const Vector3& vertex : polyhedron.mesh->hull().vertices)
                                         reach = reach.cwiseMax((rotation * vertex).cwiseAbs());
                                     return reach;
                                 }},
                      shape);
}

double reach_along(const Shape& shape, const Matrix3& rotation, const Vector3& direction) {
    return std::visit(
        Overloaded{[&](const Box& box) { return (rotation.transpose() * direction).cwiseAbs().dot(box.half_size); },
                   [&](const Sphere& sphere) { return sphere.radius * direction.norm(); },
                   [](const Plane&) { return infinity; },
                   [&](const Polyhedron& polyhedron) {
                       return support(polyhedron.mesh->hull(), rotation.transpose() * direction);
                   }},
        shape);
}

double squared_turning_radius(const Shape& shape) {
    return std::visit(Overloaded{[](const Box& box) { return box.half_size.squaredNorm(); },
                                 [](const Sphere&) { return 0.0; }, [](const Plane&) { return 0.0; },
                                 [](const Polyhedron& polyhedron) { return polyhedron.mesh->squared_radius(); }},
                      shape);
}

}  // namespace pushfactor::engine::collision
