// Towers of equal cubes above the ground: stack, intersecting-stack, heavy-on-light.
#include "demos/scenes/named/named_scenes.h"
#include "demos/scenes/random.h"

#include <array>
#include <cmath>
#include <numbers>

namespace pushfactor::demos::scenes {

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

namespace {

// Shows everything up to `height` [m].
View view_of_height(double height) {
    return view_of(Vector3(0, 0.46 * height, 0), height);
}

constexpr std::array stack_parameters{
    Parameter{"count", "N", "number of cubes [5]", 5, 1, 1000, true},
    Parameter{"gap", "M", "space between the cubes in m, and when given under the lowest too [0.6; 0.8 there]", 0.6,
              -2.3, 100},
    Parameter{"jitter", "M", "each cube starts up to M m sideways and turned by up to 0.02 rad [0]", 0, 0, 10},
    Parameter{"seed", "N", "seed of the jitter [1]", 1, 0, 1e9, true},
};

// Paper section 10.1: cubes of 2.4 m and 1.2 kg, gravity 10 m/s^2, centres 3 m apart, the lowest 2 m above the
// ground.
SceneDescription describe_stack(const ParameterValues& parameters) {
    Tower tower;
    tower.count = parameters.whole("count");
    tower.gap = parameters.number("gap");
    if (parameters.given("gap")) tower.ground_gap = tower.gap;
    tower.jitter = parameters.number("jitter");
    tower.seed = parameters.whole("seed");

    SceneDescription scene = cube_tower(tower);
    scene.view = view_of_height(tower.ground_gap + tower.count * tower.side + (tower.count - 1) * tower.gap);
    return scene;
}

constexpr std::array intersecting_stack_parameters{
    Parameter{"count", "N", "number of cubes [5]", 5, 1, 1000, true},
    Parameter{"gap", "M", "space between the cubes in m, below zero is overlap [-0.4]", -0.4, -2.3, 100},
};

// Paper section 10.2: the cubes of 10.1 with their centres 2 m apart, an overlap of 0.4 m; the lowest overlaps the
// ground by 1.2 m. The original method throws them up, the single-frame push sets them down (Figure 7).
SceneDescription describe_intersecting_stack(const ParameterValues& parameters) {
    Tower tower;
    tower.count = parameters.whole("count");
    tower.gap = parameters.number("gap");
    tower.ground_gap = -0.5 * tower.side;

    SceneDescription scene = cube_tower(tower);
    // The same view for every push, so that pictures are comparable: a little more than the stack at rest. Cubes
    // that are thrown up leave it, unless --camera fit follows them.
    scene.view = view_of_height(1.25 * tower.count * tower.side);
    return scene;
}

constexpr std::array heavy_on_light_parameters{
    Parameter{"count", "N", "number of cubes [2]", 2, 1, 1000, true},
    Parameter{"mass-ratio", "R", "how much heavier the topmost cube is [100]", 100, 1e-6, 1e9},
};

// A tower of touching cubes of 1 m and 1 kg, the topmost R times heavier. Each iteration carries a share of the
// weight down, so the number of iterations needed grows with R.
SceneDescription describe_heavy_on_light(const ParameterValues& parameters) {
    const Tower tower{
        .count = parameters.whole("count"), .side = 1.0, .mass = 1.0, .gap = -1e-4, .ground_gap = -1e-4};
    SceneDescription scene = cube_tower(tower);
    scene.bodies.back().mass = parameters.number("mass-ratio");
    scene.view = view_of_height(tower.count);
    return scene;
}

}  // namespace

constinit const SceneEntry stack{
    "stack", "Five cubes fall onto the ground and onto each other, and should stand (Figure 6).", stack_parameters,
    describe_stack};

constinit const SceneEntry intersecting_stack{
    "intersecting-stack",
    "Five cubes start inside each other and half in the ground, and should part gently (Figure 7).",
    intersecting_stack_parameters, describe_intersecting_stack};

constinit const SceneEntry heavy_on_light{
    "heavy-on-light", "A heavy cube stands on light ones: a mass ratio that iterations alone do not solve.",
    heavy_on_light_parameters, describe_heavy_on_light};

}  // namespace pushfactor::demos::scenes
