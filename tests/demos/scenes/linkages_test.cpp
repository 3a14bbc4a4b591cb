// Bodies on joints and ropes that fall: onto the ground with restitution, onto each other, and over a ball; and
// arms whose motors drive them against their limits.
#include "demos/scenes/scene_file.h"
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/scene_fixture.h"
#include "tests/settings.h"

#include <string>

using namespace pushfactor;
using namespace pushfactor::demos;
using engine::Vector3;

namespace {

constexpr double length = 0.4, gap = 0.1;  // m, of a rod and between two

SceneDescription on_the_ground(double restitution) {
    SceneDescription scene;
    scene.name = "linkages";
    scene.contacts = true;
    scene.gravity = {0, -9.81, 0};
    scene.bodies.push_back({.name = "ground", .shape = PlaneShape{}, .friction = 0.5, .restitution = restitution});
    return scene;
}

// Rods on ball joints or hinges, half of which have limits, along `along` (unit length) around `middle` [m]. Rods
// of a chain do not touch each other.
void add_chain(SceneDescription& scene, int count, const Vector3& middle, double angle, double restitution,
               tests::Random& random) {
    const engine::Quaternion turned(Eigen::AngleAxisd(angle, Vector3::UnitZ()));
    const std::string chain = std::to_string(scene.bodies.size());
    for (int i = 0; i < count; ++i) {
        const double along = (i - 0.5 * (count - 1)) * (length + gap);
        scene.bodies.push_back({.name = chain + " " + std::to_string(i),
                                .shape = BoxShape{{length, 0.05, 0.1}},
                                .mass = random.in(1.0, 4.0),
                                .position = middle + turned * Vector3(along, 0, 0),
                                .orientation = turned,
                                .friction = 0.5,
                                .restitution = restitution,
                                .group = chain});
        if (i == 0) continue;
        const Vector3 end(0.5 * (length + gap), 0, 0);
        JointDescription joint{.a = {chain + " " + std::to_string(i - 1), end},
                               .b = {chain + " " + std::to_string(i), -end}};
        if (random.in(0.0, 1.0) < 0.5) {
            joint.hinge.emplace();
            joint.hinge->axis = Vector3::UnitZ();
            if (random.in(0.0, 1.0) < 0.5) joint.hinge->limits = {{-1.0, 0.5}};
        }
        scene.joints.push_back(joint);
    }
}

// Links on top of each other with a load at the end, each with a motor of its own kind that ends at a limit.
SceneDescription arm(tests::Random& random) {
    SceneDescription scene;
    scene.gravity = {0, -9.81, 0};
    const Vector3 end(0, 0.3, 0);
    scene.bodies.push_back({.name = "base", .shape = BoxShape{{0.4, 0.6, 0.4}}});
    for (int i = 1; i <= 4; ++i) {
        scene.bodies.push_back({.name = std::to_string(i),
                                .shape = BoxShape{{0.1, 0.6, 0.1}},
                                .mass = i < 4 ? random.in(1.0, 3.0) : random.in(0.1, 20.0),
                                .position = 2.0 * i * end});
        JointDescription joint{.a = {scene.bodies[static_cast<std::size_t>(i) - 1].name, end},
                               .b = {scene.bodies.back().name, -end}};
        joint.hinge.emplace();
        joint.hinge->axis = random.in(0.0, 1.0) < 0.5 ? Vector3::UnitX() : Vector3::UnitZ();
        joint.hinge->limits = {{-1.5, 1.5}};
        joint.hinge->motor = engine::Motor{.speed = random.in(-2.0, 2.0)};
        if (random.in(0.0, 1.0) < 0.3) joint.hinge->motor->max_torque = 200.0;
        scene.joints.push_back(joint);
    }
    return scene;
}

// A square net of balls and ropes above a ball of 0.8 m.
SceneDescription net_of_ropes(int side) {
    SceneDescription scene = on_the_ground(0.0);
    scene.bodies.push_back({.name = "big", .shape = SphereShape{0.4}, .position = {0, 0.4, 0}, .friction = 0.5});
    const auto name = [](int i, int k) { return std::to_string(i) + " " + std::to_string(k); };
    const auto rope = [&](const std::string& a, const std::string& b) {
        scene.distances.push_back({.a = {a}, .b = {b}, .acts = engine::Distance::Acts::pulls});
    };
    for (int i = 0; i < side; ++i) {
        for (int k = 0; k < side; ++k) {
            const Vector3 middle(0.15 * (i - 0.5 * (side - 1)), 1.3 + 0.001 * (i + 2 * k),
                                 0.15 * (k - 0.5 * (side - 1)));
            scene.bodies.push_back({.name = name(i, k),
                                    .shape = SphereShape{0.03},
                                    .mass = 0.05,
                                    .position = middle,
                                    .friction = 0.5,
                                    .group = "net"});
            if (i > 0) rope(name(i - 1, k), name(i, k));
            if (k > 0) rope(name(i, k - 1), name(i, k));
        }
    }
    return scene;
}

Simulation simulate(const SceneDescription& scene) {
    const Settings settings = tests::awake_settings("default");
    return Simulation(build_scene(scene, settings), settings);
}

}  // namespace

TEST_CASE("chains of rods that land with restitution gain no energy") {
    {
        // Two impacts of the first rod in one step: 46.6 J if joints keep what flying gave them.
        INFO("landing-rods.json");
        const Settings settings = tests::awake_settings("default");
        const std::string file = PUSHFACTOR_SOURCE_DIR "/tests/scenes/landing-rods.json";
        tests::Run run(Simulation(build_scene(read_scene_file(file), settings), settings));
        run.advance(2.0);
        CHECK(run.measurements.energy_gain() < 1e-3 * run.measurements.initial_energy());
    }
    for (unsigned seed = 0; seed < 40; ++seed) {
        CAPTURE(seed);
        tests::Random random(seed);
        const double restitution = random.in(0.2, 1.0);
        SceneDescription scene = on_the_ground(restitution);
        add_chain(scene, 2 + static_cast<int>(seed % 5), {0, random.in(2.0, 4.0), 0}, random.in(-1.5, 1.5),
                  restitution, random);
        tests::Run run(simulate(scene));
        run.advance(2.0);
        CHECK(run.measurements.energy_gain() < 1e-3 * run.measurements.initial_energy());
    }
}

TEST_CASE("a heap of chains takes small steps, as any heap") {
    tests::Random random(7);
    SceneDescription scene = on_the_ground(0.0);
    for (int k = 0; k < 8; ++k) {
        add_chain(scene, 2 + k % 3, {random.in(-0.4, 0.4), 0.5 + 0.5 * k, random.in(-0.4, 0.4)}, 0.1, 0.0, random);
    }
    Simulation run = simulate(scene);
    double work = 0.0;
    while (run.sample().time < 3.0) work += run.advance().count.multiply_adds;
    CHECK(work < 1.5e9);  // measured 0.73e9; with exact solutions of all that has joints 3.4e9
}

TEST_CASE("chains whose links touch each other take small steps too: a contact does not make a loop of joints") {
    tests::Random random(3);
    SceneDescription scene = on_the_ground(0.0);
    for (int k = 0; k < 2; ++k) add_chain(scene, 10, {0, 2.5 + k, 0.3 * k}, 1.4, 0.0, random);
    for (BodyDescription& body : scene.bodies) body.group.clear();
    Simulation run = simulate(scene);
    double work = 0.0;
    while (run.sample().time < 3.0) work += run.advance().count.multiply_adds;
    CHECK(work < 1e9);  // measured 0.26e9; solved exactly 5.0e9
}

TEST_CASE("arms whose motors drive them against their limits are solved, and gain no energy") {
    for (unsigned seed = 0; seed < 12; ++seed) {
        CAPTURE(seed);
        tests::Random random(seed);
        tests::Run run(simulate(arm(random)));
        run.advance(4.0);
        CHECK(run.measurements.unsolved().count == 0);
        CHECK(run.measurements.energy_gain() < 1e-4 * run.measurements.initial_energy());
    }
}

TEST_CASE("a net of taut ropes over a ball takes small steps, and is solved in each") {
    Simulation run = simulate(net_of_ropes(7));
    double work = 0.0;
    int unsolved = 0;
    while (run.sample().time < 3.0) {
        const engine::StepCount count = run.advance().count;
        work += count.multiply_adds;
        unsolved += count.islands_unsolved;
    }
    CHECK(unsolved == 0);
    CHECK(work < 1e9);
}
