#include "demos/pictures/camera/plane_outline.h"

namespace pushfactor::demos::pictures {

namespace {

using engine::Vector3;
using Polygon = std::vector<Vector3>;

// Sutherland-Hodgman clipping: keeps the part on the side of `normal` of the plane through `point`.
Polygon clip(const Polygon& polygon, const Vector3& normal, const Vector3& point) {
    Polygon result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vector3& from = polygon[i];
        const Vector3& to = polygon[(i + 1) % polygon.size()];
        const double in_from = normal.dot(from - point);
        const double in_to = normal.dot(to - point);
        if (in_from >= 0.0) result.push_back(from);
        if ((in_from >= 0.0) != (in_to >= 0.0))
            result.push_back(from + (to - from) * (in_from / (in_from - in_to)));
    }
    return result;
}

double area(const Polygon& polygon) {
    Vector3 twice = Vector3::Zero();
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        twice += (polygon[i - 1] - polygon[0]).cross(polygon[i] - polygon[0]);
    }
    return 0.5 * twice.norm();
}

}  // namespace

bool is_level(const engine::Body& plane) {
    return (plane.orientation * Vector3::UnitY()).y() > 0.9999;
}

std::optional<double> ground_height(const BuiltScene& scene) {
    std::optional<double> height = scene.view.floor;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const engine::Body& body = scene.world.bodies[i];
        if (std::holds_alternative<PlaneShape>(scene.bodies[i].shape) && is_level(body)) height = body.position.y();
    }
    return height;
}

std::vector<Vector3> plane_outline(const BuiltScene& scene, const engine::Body& plane) {
    const engine::Matrix3 frame = plane.orientation.toRotationMatrix();
    const Vector3 up = frame.col(1);
    const double reach = (scene.view.eye - scene.view.target).norm();
    const Vector3 middle = scene.view.target - up * up.dot(scene.view.target - plane.position);

    const Vector3 u = reach * frame.col(0);
    const Vector3 v = reach * frame.col(2);
    Polygon polygon{middle + u + v, middle + u - v, middle - u - v, middle - u + v};
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const engine::Body& other = scene.world.bodies[i];
        if (&other == &plane || !std::holds_alternative<PlaneShape>(scene.bodies[i].shape)) continue;
        polygon = clip(polygon, other.orientation * Vector3::UnitY(), other.position);
    }
    // Cut at a rim that is inside the picture.
    polygon = clip(polygon, -Vector3::UnitY(), scene.view.target + Vector3(0, 0.09 * reach, 0));
    return area(polygon) > 1e-4 * reach * reach ? polygon : Polygon{};
}

}  // namespace pushfactor::demos::pictures
