// Paper section 10.3: "20 balls in a pyramid funnel created out of 4 infinite planes". The paper gives no numbers:
// here the planes are inclined by 45 degrees and meet at the origin, and the balls have 0.5 m radius and 1 kg.
#include "demos/scenes/named/named_scenes.h"
#include "demos/scenes/random.h"

#include <array>
#include <cmath>
#include <numbers>

namespace pushfactor::demos::scenes {

using engine::Quaternion;
using engine::Vector3;

namespace {

constexpr double radius = 0.5;  // m
constexpr double friction = 0.3;
constexpr double spacing = 1.1;      // m between the balls of a tower at the start
constexpr double first_layer = 4.0;  // m above the tip
constexpr int in_the_tower = 20;     // more balls than this start in layers

void add_ball(SceneDescription& scene, const Vector3& position) {
    scene.bodies.push_back({.name = "ball " + std::to_string(scene.bodies.size() - 3),
                            .shape = SphereShape{radius},
                            .mass = 1.0,
                            .position = position,
                            .friction = friction});
}

void add_tower(SceneDescription& scene, int count, Random& random) {
    for (int k = 0; k < count; ++k) {
        const double x = random.in(-0.4, 0.4);
        const double z = random.in(-0.4, 0.4);
        add_ball(scene, {x, first_layer + spacing * k, z});
    }
}

}  // namespace

void add_funnel_planes(SceneDescription& scene, double mu) {
    for (int k = 0; k < 4; ++k) {
        const Quaternion turn = exponential(0.5 * std::numbers::pi * k * Vector3::UnitY());
        const Quaternion tilt = exponential(-0.25 * std::numbers::pi * Vector3::UnitZ());
        scene.bodies.push_back({.name = "plane " + std::to_string(k + 1),
                                .shape = PlaneShape{},
                                .orientation = turn * tilt,
                                .friction = mu});
    }
}

std::vector<Vector3> funnel_places(int count, double reach, Random& random) {
    const double apart = 2.2 * reach, jitter = 0.08 * reach;
    std::vector<Vector3> places;
    int left = count;
    for (double height = first_layer; left > 0; height += apart) {
        // At 45 degrees a ball clears the plane while |x| <= height - reach sqrt(2).
        const double widest = height - std::numbers::sqrt2 * reach - 0.1;
        const int side = 1 + static_cast<int>(std::floor(2.0 * widest / apart));
        const double corner = -0.5 * apart * (side - 1);
        for (int cell = 0; cell < side * side && left > 0; ++cell, --left) {
            const double x = corner + apart * (cell % side) + random.in(-jitter, jitter);
            const int row = cell / side;
            const double z = corner + apart * row + random.in(-jitter, jitter);
            places.emplace_back(x, height, z);
        }
    }
    return places;
}

View view_into_funnel(int count) {
    // The bodies fill a pyramid: its volume 4/3 h^3 holds them at a packing of about 0.6.
    const double heap = elementary::cbrt(0.75 * count * (4.19 * radius * radius * radius) / 0.6) + 1.0;
    View view = view_of({0, 0.65 * heap, 0}, 1.6 * heap);
    view.eye.y() += 0.6 * heap;
    return view;
}

namespace {

constexpr std::array funnel_parameters{
    Parameter{"count", "N", "number of balls, above 20 in layers [20]", 20, 1, 100000, true},
    Parameter{"seed", "N", "seed of the places at the start [1]", 1, 0, 1e9, true},
};

SceneDescription describe_funnel(const ParameterValues& parameters) {
    SceneDescription scene;
    scene.contacts = true;
    add_funnel_planes(scene, friction);

    const int count = parameters.whole("count");
    Random random(parameters.whole("seed"));
    if (count <= in_the_tower) {
        add_tower(scene, count, random);
    } else {
        for (const Vector3& place : funnel_places(count, radius, random)) add_ball(scene, place);
    }
    scene.view = view_into_funnel(count);
    return scene;
}

}  // namespace

constinit const SceneEntry funnel{
    "funnel", "Twenty balls fall into a funnel of four infinite planes and come to rest (Figure 8).",
    funnel_parameters, describe_funnel};

}  // namespace pushfactor::demos::scenes
