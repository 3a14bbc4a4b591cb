// What falls onto towers: a body that is hundreds of times as heavy, and plates much thinner than wide.
#include "tests/catch.h"
#include "tests/scene_fixture.h"
#include "tests/settings.h"

#include <algorithm>
#include <string>
#include <utility>

using namespace pushfactor;
using namespace pushfactor::demos;

namespace {

SceneDescription on_the_ground() {
    SceneDescription scene;
    scene.name = "tower";
    scene.contacts = true;
    scene.gravity = {0, -10, 0};
    scene.bodies.push_back({.name = "ground", .shape = PlaneShape{}});
    return scene;
}

Simulation simulate(const SceneDescription& scene) {
    const Settings settings = tests::awake_settings("default");
    return Simulation(build_scene(scene, settings), settings);
}

// Cubes of 1 m and 1 kg, and one of `mass` [kg] that falls onto them from 0.3 m.
Simulation under_a_falling_cube(int count, double mass) {
    SceneDescription scene = on_the_ground();
    const auto add = [&](double height, double weight) {
        scene.bodies.push_back({.name = "cube " + std::to_string(scene.bodies.size()),
                                .shape = BoxShape{{1, 1, 1}},
                                .mass = weight,
                                .position = {0, height, 0}});
    };
    for (int k = 0; k < count; ++k) add(k + 0.5, 1.0);
    add(count + 0.8, mass);
    return simulate(scene);
}

}  // namespace

TEST_CASE("a cube up to 10,000 times as heavy that falls onto a tower of 5 to 20 cubes stays on its top") {
    for (const int count : {5, 8, 12, 20}) {
        for (const double mass : {100.0, 1000.0, 10000.0}) {
            Simulation simulation = under_a_falling_cube(count, mass);
            double deepest = 0.0;
            for (int step = 0; step < 120; ++step)
                deepest = std::max(deepest, simulation.advance().penetration.max);
            INFO(count << " cubes, " << mass << " kg, " << deepest << " m deep");
            CHECK(simulation.scene().world.bodies.back().position.y() == Approx(count + 0.5).margin(1e-6));
            CHECK(deepest < 1e-6);
        }
    }
}

// With sweeps in one direction only they tremble by 3 cm/s for ever: which corner of a plate comes first decides.
TEST_CASE("ten to twenty plates of a fiftieth to a tenth of their width that fall by 1 mm come to rest") {
    for (const auto& [count, thickness] : {std::pair{10, 0.02}, {10, 0.05}, {10, 0.1}, {20, 0.02}}) {
        SceneDescription scene = on_the_ground();
        for (int k = 0; k < count; ++k) {
            scene.bodies.push_back({.name = "plate " + std::to_string(k),
                                    .shape = BoxShape{{1, thickness, 1}},
                                    .mass = 1.0,
                                    .position = {0, (k + 0.5) * thickness + (k + 1) * 1e-3, 0}});
        }
        Simulation simulation = simulate(scene);
        tests::advance(simulation, 3.0);
        INFO(count << " of " << thickness << " m");
        CHECK(simulation.sample().max_speed < 1e-6);
    }
}
