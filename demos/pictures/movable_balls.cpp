#include "demos/pictures/movable_balls.h"

#include <algorithm>

namespace pushfactor::demos::pictures {

std::vector<Ball> movable_balls(const BuiltScene& scene) {
    std::vector<Ball> balls;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        if (!goes_about(scene.bodies[i])) continue;
        balls.push_back({.centre = scene.world.bodies[i].position, .radius = bounding_radius(scene.bodies[i])});
    }
    const auto add_ends = [&](const auto& held) {
        const auto [from, to] = span_of(held, scene.world.bodies);
        balls.push_back({.centre = from});
        balls.push_back({.centre = to});
    };
    if (scene.distances) std::ranges::for_each(scene.distances->distances(), add_ends);
    if (scene.joints) std::ranges::for_each(scene.joints->joints(), add_ends);
    return balls;
}

}  // namespace pushfactor::demos::pictures
