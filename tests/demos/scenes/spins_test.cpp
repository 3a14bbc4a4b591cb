// Bodies without anything to hold them: one that spins fast, one under a force that lasts less than a step.
#include "engine/bodies/diagnostics.h"
#include "tests/catch.h"
#include "tests/scene_fixture.h"
#include "tests/settings.h"

#include <utility>

using namespace pushfactor;
using namespace pushfactor::demos;
using engine::Vector3;

namespace {

Simulation simulate(const SceneDescription& scene) {
    Settings settings = tests::awake_settings("default");
    settings.substeps = std::nullopt;
    return Simulation(build_scene(scene, settings), settings);
}

BodyDescription box(const char* name, const Vector3& size, double mass, const Vector3& spin) {
    return {.name = name, .shape = BoxShape{size}, .mass = mass, .angular_velocity = spin};
}

}  // namespace

TEST_CASE("a free box that tumbles by a radian and more in a step keeps its energy, with contacts and without") {
    for (const bool contacts : {false, true}) {
        for (const double speed : {30.0, 60.0, 100.0}) {
            SceneDescription scene;
            scene.name = "box";
            scene.gravity.setZero();
            scene.contacts = contacts;
            scene.bodies.push_back(box("box", {2, 0.1, 0.3}, 1.0, speed * Vector3(0.3, 1, 0.2)));
            Simulation simulation = simulate(scene);
            const double before = simulation.sample().kinetic_energy;
            tests::advance(simulation, 10.0);
            INFO(speed << " rad/s");
            CHECK(simulation.sample().kinetic_energy == Approx(before).epsilon(1e-6));
        }
    }
}

TEST_CASE(
    "a force that begins and ends within the first steps gives its whole impulse, with contacts and without") {
    for (const bool contacts : {false, true}) {
        for (const auto& [from, until] : {std::pair{0.0, 0.01}, {1e-4, 0.01}, {1e-4, 0.5}, {0.01, 0.02}}) {
            SceneDescription scene;
            scene.name = "pushed";
            scene.gravity.setZero();
            scene.contacts = contacts;
            scene.bodies.push_back(box("box", {1, 1, 1}, 1.0, Vector3::Zero()));
            scene.forces.push_back({.body = "box", .force = {100, 0, 0}, .from = from, .until = until});
            Simulation simulation = simulate(scene);
            tests::advance(simulation, 1.0);
            INFO(from << " to " << until << " s");
            CHECK(simulation.scene().world.bodies[0].linear_momentum.x() ==
                  Approx(100.0 * (until - from)).epsilon(1e-12));
        }
    }
}
