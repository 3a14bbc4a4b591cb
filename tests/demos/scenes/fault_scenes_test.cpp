// Scenes of former faults, as files that the program runs too: tests/scenes.
#include "demos/options/named_run.h"
#include "demos/scenes/scene_file.h"
#include "engine/bodies/diagnostics.h"
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/scene_fixture.h"
#include "tests/settings.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

using namespace pushfactor;
using namespace pushfactor::demos;
using engine::Body;

namespace {

std::string file_of(const std::string& name) {
    return PUSHFACTOR_SOURCE_DIR "/tests/scenes/" + name;
}

Simulation load(const char* name, const Settings& settings) {
    return Simulation(build_scene(read_scene_file(file_of(name)), settings), settings);
}

const Body& last_body(const Simulation& simulation) {
    return simulation.scene().world.bodies.back();
}

// By default and exactly, with one and with sixteen substeps.
template <typename Check>
void in_all_settings(Check check) {
    for (const char* preset : {"default", "exact"}) {
        for (const int substeps : {1, 16}) {
            Settings settings = tests::awake_settings(preset);
            settings.substeps = substeps;
            INFO(preset << ", substeps " << substeps);
            check(settings);
        }
    }
}

}  // namespace

TEST_CASE(
    "a cube that hovers in the margin keeps its 1 m/s to rounding and does not tumble, whatever the friction") {
    in_all_settings([](Settings settings) {
        for (const auto model : {FrictionModel::paper, FrictionModel::coulomb, FrictionModel::cone}) {
            settings.friction_model = model;
            Simulation simulation = load("fault-1-hovering-cube.json", settings);
            tests::advance(simulation, 1.0);
            CHECK((velocity(last_body(simulation)) - engine::Vector3(1, 0, 0)).norm() < 1e-12);
            CHECK(angular_velocity(last_body(simulation)).norm() < 1e-12);
        }
    });
}

TEST_CASE("twenty thin plates that fall onto each other, each turned by 7 degrees, come to rest") {
    for (const char* preset : {"default", "exact"}) {
        INFO(preset);
        Simulation simulation = load("turned-plates.json", tests::awake_settings(preset));
        tests::advance(simulation, 5.0);
        double fastest = 0.0;
        for (const Body& body : simulation.scene().world.bodies) fastest = std::max(fastest, velocity(body).norm());
        CHECK(fastest < 1e-7);
    }
}

TEST_CASE("a cube that slides at 0.3 m/s along the diagonal of its edges loses mu g t, with 1 to 64 substeps") {
    for (const char* preset : {"default", "exact"}) {
        for (const int substeps : {1, 4, 16, 64}) {
            Settings settings = tests::awake_settings(preset);
            settings.substeps = substeps;
            INFO(preset << ", substeps " << substeps);
            Simulation simulation = load("fault-4-slow-slide.json", settings);
            tests::advance(simulation, 0.05);
            CHECK(velocity(last_body(simulation)).x() == Approx(0.15 * std::sqrt(0.5)).margin(1e-6));
            CHECK(velocity(last_body(simulation)).z() == Approx(0.15 * std::sqrt(0.5)).margin(1e-6));
        }
    }
}

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

TEST_CASE(
    "a force that begins on a heap at rest is answered in the step after: the kept guess is dropped at once") {
    // By sweeps, because an exact solve responds in the same step.
    Choices choices = understand(file_of("fault-7-heap-then-force.json"), {});
    choices.settings.solver = "pgs";
    choices.settings.rest = false;
    Simulation heap(choices);
    int kept = 0;
    for (int i = 0; i < 600; ++i) {
        heap.advance();
        kept = i < 500 ? 0 : kept + heap.sample().count.islands_kept;
    }
    CHECK(kept > 25);
    REQUIRE(heap.sample().residual <= choices.settings.tolerance_high);
    const double first = heap.advance().residual;
    REQUIRE(first > 1e4 * choices.settings.tolerance_high);
    // Measured 0.81 of it, and 1.00 when the kept guess was still used.
    CHECK(heap.advance().residual < 0.9 * first);
}

TEST_CASE("a layer of cubes has its rows in the same order when their heights differ by a rounding") {
    const auto bodies_of_rows = [](double jitter) {
        Choices choices = understand(file_of("fault-13-layer.json"), {});
        tests::Random random(75);
        for (BodyDescription& body : choices.description.bodies) {
            if (body.mass) body.position.y() += random.in(-jitter, jitter);
        }
        Simulation layer(choices);
        std::vector<std::pair<int, int>> pairs;
        for (int i = 0; i < 5; ++i) {
            layer.advance();
            for (const auto& row : layer.scene().world.rows()) {
                const std::pair pair{row.body_a, row.body_b};
                if (pairs.empty() || pairs.back() != pair) pairs.push_back(pair);
            }
        }
        return pairs;
    };
    const auto expected = bodies_of_rows(0.0);
    CHECK(expected.size() > 500);
    CHECK(bodies_of_rows(1e-12) == expected);
}

TEST_CASE("a force that acts from the start and ends leaves all of its impulse") {
    for (const char* preset : {"default", "exact"}) {
        Simulation ball = load("force-at-the-start.json", tests::awake_settings(preset));
        tests::advance(ball, 1.0);
        CHECK(velocity(last_body(ball)).x() == Approx(100.0 / 60.0).epsilon(1e-12));
    }
}

TEST_CASE("a ball that falls close behind another does not pass into it where that one is stopped") {
    for (const double gap : {0.003, 0.01, 0.02, 0.03}) {
        for (int n = 0; n < 50; ++n) {
            const double height = 1.0 + 0.08 * n;
            SceneDescription scene;
            scene.name = "followers";
            scene.contacts = true;
            scene.gravity = {0, -9.81, 0};
            const auto add = [&](const char* name, double y) {
                scene.bodies.push_back(
                    {.name = name, .shape = SphereShape{0.1}, .mass = 1.0, .position = {0, y, 0}});
            };
            scene.bodies.push_back({.name = "ground", .shape = PlaneShape{}});
            add("low", height);
            add("high", height + 0.2 + gap);
            const Settings settings = tests::awake_settings("default");
            Simulation simulation(build_scene(scene, settings), settings);
            double deepest = 0.0;
            for (int step = 0; step < 90; ++step) deepest = std::max(deepest, simulation.advance().penetration.max);
            INFO("gap " << gap << " m, from " << height << " m");
            CHECK(deepest < 0.005);
        }
    }
}

// A pair was in contact after rebounds that would leave a tenth of its speed, however often it was driven together
// again: of 1200 such lines 296 overlapped by more than 5 mm, and by up to 20 cm; now the worst has 2.7 mm.
TEST_CASE("light balls that a fast one drives against a wall or a heavy one end between them, and gain nothing") {
    tests::Random random(1);
    for (int n = 0; n < 60; ++n) {
        const double restitution = random.in(0.05, 0.95);
        SceneDescription scene;
        scene.name = "sandwich";
        scene.contacts = true;
        scene.gravity = engine::Vector3::Zero();
        double x = 0.0;
        const auto add = [&](const std::string& name, double mass) {
            scene.bodies.push_back({.name = name,
                                    .shape = SphereShape{0.1},
                                    .mass = mass,
                                    .position = {x, 0, 0},
                                    .restitution = restitution});
            x += 0.2 + random.in(0.0005, 0.03);
        };
        add("fast", 1.0);
        scene.bodies.back().velocity = {random.in(3.0, 40.0), 0, 0};
        for (int k = 0; k <= n % 3; ++k) add("light " + std::to_string(k), std::pow(10.0, random.in(-2.0, 0.3)));
        add("last", random.in(5.0, 50.0));
        if (n % 2 == 0) scene.bodies.back().mass.reset();
        const Settings settings = tests::awake_settings("default");
        tests::Run run(Simulation(build_scene(scene, settings), settings));
        double deepest = 0.0;
        for (int step = 0; step < 30; ++step) {
            run.advance(1.0 / 60.0);
            deepest = std::max(deepest, run.simulation.sample().penetration.max);
        }
        INFO(n << ", restitution " << restitution);
        CHECK(deepest < 0.005);
        CHECK(run.measurements.energy_gain() < 1e-9 * run.measurements.initial_energy());
    }
}
