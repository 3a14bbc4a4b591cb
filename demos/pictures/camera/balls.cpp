#include "demos/pictures/camera/balls.h"

#include <algorithm>

namespace pushfactor::demos::pictures {

using engine::Vector3;

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
    const auto add = [&](const auto& held) {
        const auto [from, to] = span_of(held, scene.world.bodies);
        points.push_back({.centre = from});
        points.push_back({.centre = to});
    };
    if (scene.distances) std::ranges::for_each(scene.distances->distances(), add);
    if (scene.joints) std::ranges::for_each(scene.joints->joints(), add);
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
