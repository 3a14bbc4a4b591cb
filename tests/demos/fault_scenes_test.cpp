// Scenes in which something went wrong once, as files that the program runs too: tests/scenes.
#include "demos/scene_file.h"
#include "engine/diagnostics.h"
#include "tests/catch.h"
#include "tests/scene_fixture.h"

#include <filesystem>

using namespace pushfactor;
using namespace pushfactor::demos;
using engine::Body;

namespace {

Simulation load(const char* name, const Settings& settings) {
    const std::filesystem::path file = std::filesystem::path(PUSHFACTOR_SOURCE_DIR) / "tests/scenes" / name;
    return Simulation(build_scene(read_scene_file(file), settings), settings);
}

const Body& last_body(const Simulation& simulation) {
    return simulation.scene().world.bodies.back();
}

// By default and exactly, with one and with sixteen substeps.
template <typename Check>
void in_all_settings(Check check) {
    for (const char* preset : {"default", "exact"}) {
        for (const int substeps : {1, 16}) {
            Settings settings = preset_settings(preset);
            settings.substeps = substeps;
            INFO(preset << ", substeps " << substeps);
            check(settings);
        }
    }
}

}  // namespace

TEST_CASE("a frictionless cube that slides over a seam keeps its speed and does not begin to spin") {
    in_all_settings([](const Settings& settings) {
        Simulation simulation = load("fault-3-seam.json", settings);
        tests::advance(simulation, 2.0);
        CHECK(velocity(last_body(simulation)).x() == Approx(4.0).epsilon(1e-6));
        CHECK(angular_velocity(last_body(simulation)).norm() < 1e-5);
        CHECK(last_body(simulation).position.y() == Approx(0.5).margin(1e-5));
    });
}

TEST_CASE("a ball that is pressed at a plate from above by 27 kN ends on the plate") {
    in_all_settings([](const Settings& settings) {
        Simulation simulation = load("fault-5-pressed-ball.json", settings);
        tests::advance(simulation, 1.0);
        CHECK(last_body(simulation).position.y() == Approx(0.1).margin(1e-5));
        CHECK(velocity(last_body(simulation)).norm() < 1e-5);
    });
}

TEST_CASE("a slightly tilted box that spins at 1000 rad/s settles on its plate") {
    in_all_settings([](const Settings& settings) {
        Simulation simulation = load("fault-9-spinning-tilted-box.json", settings);
        const double energy = kinetic_energy(simulation.scene().world.bodies);
        for (int n = 0; n < 120; ++n) {
            simulation.advance();
            CHECK(last_body(simulation).position.y() > 0.09);
            CHECK(kinetic_energy(simulation.scene().world.bodies) < 1.01 * energy);
        }
    });
}
