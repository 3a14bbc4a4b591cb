#include "demos/scenes/named/cube_tower.h"

#include "demos/scenes/named/view.h"
#include "demos/scenes/random.h"

#include <cmath>
#include <numbers>

namespace pushfactor::demos::scenes {

using engine::Quaternion;
using engine::Vector3;

namespace {

void displace(BodyDescription& body, double reach, Random& random) {
    const double distance = reach * std::sqrt(random.in(0.0, 1.0));
    const double direction = random.in(0.0, 2.0 * std::numbers::pi);
    const double turn = random.in(-0.02, 0.02);
    body.position += Vector3(distance * elementary::cos(direction), 0.0, distance * elementary::sin(direction));
    body.orientation = exponential(turn * Vector3::UnitY());
}

}  // namespace

SceneDescription cube_tower(const Tower& tower) {
    SceneDescription scene;
    scene.contacts = true;
    scene.standing = Standing{.side = tower.side, .rest_heights = {}};
    scene.bodies.push_back({.name = "ground", .shape = PlaneShape{}});

    Random random(tower.seed);
    for (int i = 0; i < tower.count; ++i) {
        BodyDescription cube{.name = "cube " + std::to_string(i + 1),
                             .shape = BoxShape{Vector3::Constant(tower.side)},
                             .mass = tower.mass};
        cube.position.y() = 0.5 * tower.side + tower.ground_gap + i * (tower.side + tower.gap);
        if (tower.jitter > 0.0) displace(cube, tower.jitter, random);
        scene.bodies.push_back(cube);
        scene.standing->rest_heights.push_back((i + 0.5) * tower.side);
    }
    return scene;
}

View view_of_height(double height) {
    return view_of(Vector3(0, 0.46 * height, 0), height);
}

}  // namespace pushfactor::demos::scenes
