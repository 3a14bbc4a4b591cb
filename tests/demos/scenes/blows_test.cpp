// What falls onto structures: a blow takes energy and gives none, and heavy bodies rest on light ones.
#include "engine/bodies/integrator.h"
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/scene_fixture.h"
#include "tests/settings.h"

#include <array>

using namespace pushfactor;
using namespace pushfactor::demos;
using engine::Vector3;

namespace {

constexpr double gravity = 9.81;  // m/s^2

std::string number(int k) {
    return std::to_string(k);
}

void add_ball(SceneDescription& scene, const std::string& name, double mass, const Vector3& position) {
    scene.bodies.push_back(
        {.name = name, .shape = SphereShape{0.24}, .mass = mass, .position = position, .friction = 0.5});
}

constexpr double length = 0.5;  // m, of bars and planks

SceneDescription empty_scene(const std::string& name) {
    SceneDescription scene;
    scene.name = name;
    scene.contacts = true;
    scene.gravity = {0, -gravity, 0};
    return scene;
}

// Balls of 1 kg on bars of 0.5 m, which hang in an arc between two fixed points, and a heavier one above.
SceneDescription line_of_bars(int balls, double mass, double height, double off, engine::Distance::Acts acts) {
    SceneDescription scene = empty_scene("line");
    Vector3 point = Vector3::Zero();
    DistanceDescription::End last{"world", point};
    const int bars = balls + 1;
    for (int k = 0; k < bars; ++k) {
        const double slope = 0.3 * (2.0 * k - (bars - 1)) / bars;
        point += length * Vector3(std::cos(slope), std::sin(slope), 0);
        DistanceDescription::End next{"world", point};
        if (k < balls) {
            add_ball(scene, number(k), 1.0, point);
            next = {number(k), Vector3::Zero()};
        }
        scene.distances.push_back({.a = last, .b = next, .length = length, .acts = acts});
        last = next;
    }
    add_ball(scene, "heavy", mass, {0.5 * point.x() + off, height, 0});
    return scene;
}

// Planks of 1 kg on hinges between two fixed points, hanging by `sag` [rad] at the ends, and a heavier ball above.
SceneDescription line_of_planks(int planks, double sag, double mass, double height, double off) {
    SceneDescription scene = empty_scene("planks");
    Vector3 point = Vector3::Zero();
    DistanceDescription::End last{"world", point};
    const auto join = [&](const DistanceDescription::End& a, const DistanceDescription::End& b) {
        JointDescription joint{.a = a, .b = b};
        joint.hinge = HingeDescription{.axis = Vector3::UnitZ()};
        scene.joints.push_back(joint);
    };
    for (int k = 0; k < planks; ++k) {
        const double slope = planks > 1 ? sag * (2.0 * k / (planks - 1) - 1.0) : 0.0;
        const Vector3 along(std::cos(slope), std::sin(slope), 0);
        scene.bodies.push_back({.name = number(k),
                                .shape = BoxShape{{0.9 * length, 0.05, 1.0}},
                                .mass = 1.0,
                                .position = point + 0.5 * length * along,
                                .orientation = engine::exponential(slope * Vector3::UnitZ()),
                                .friction = 0.5});
        join(last, {number(k), {-0.5 * length, 0, 0}});
        last = {number(k), {0.5 * length, 0, 0}};
        point += length * along;
    }
    join({"world", point}, last);
    add_ball(scene, "heavy", mass, {0.5 * point.x() + off, height, 0});
    return scene;
}

tests::Run run_of(const SceneDescription& scene, const Rational& dt) {
    Settings settings = tests::awake_settings("default");
    settings.dt = dt;
    return tests::Run(Simulation(build_scene(scene, settings), settings));
}

}  // namespace

TEST_CASE("a ball that falls onto a line of bars or ropes gains no energy, however light they are") {
    tests::Random random(3);
    constexpr std::array steps{Rational{1, 60}, Rational{1, 240}};
    for (int trial = 0; trial < 24; ++trial) {
        const int balls = 2 + trial % 7;
        const double mass = std::pow(10.0, random.in(0.0, 2.0)), height = random.in(0.6, 1.5);
        const auto acts = trial % 3 == 2 ? engine::Distance::Acts::pulls : engine::Distance::Acts::both;
        tests::Run run = run_of(line_of_bars(balls, mass, height, random.in(-0.2, 0.2), acts), steps[trial % 2]);
        run.advance(2.0);
        INFO("trial " << trial << ", " << balls << " balls, " << mass << " kg");
        CHECK(run.measurements.energy_gain() < 0.01 * mass * gravity * height);
    }
}

TEST_CASE("a ball that falls onto planks on hinges between two fixed points gains no energy") {
    tests::Random random(5);
    constexpr std::array steps{Rational{1, 60}, Rational{1, 240}};
    for (int trial = 0; trial < 24; ++trial) {
        const int planks = 2 + trial % 7;
        const double mass = std::pow(10.0, random.in(0.0, 2.0)), height = random.in(0.6, 1.5);
        const double sag = random.in(0.02, 0.4);
        tests::Run run = run_of(line_of_planks(planks, sag, mass, height, random.in(-0.2, 0.2)), steps[trial % 2]);
        run.advance(2.0);
        INFO("trial " << trial << ", " << planks << " planks, sag " << sag << ", " << mass << " kg");
        CHECK(run.measurements.energy_gain() < 0.01 * mass * gravity * height);
    }
}

TEST_CASE("a heavy cube that lands on a few light ones rests on them, and not in them") {
    tests::Random random(4);
    for (int trial = 0; trial < 24; ++trial) {
        const int cubes = 1 + trial % 4;
        const double ratio = std::pow(10.0, random.in(1.5, 4.0));
        SceneDescription scene = empty_scene("cubes");
        scene.bodies.push_back({.name = "ground", .shape = PlaneShape{}, .friction = 0.5});
        const auto add = [&](const std::string& name, double mass, double x, double y) {
            scene.bodies.push_back(
                {.name = name, .shape = BoxShape{{1, 1, 1}}, .mass = mass, .position = {x, y, 0}, .friction = 0.5});
        };
        for (int k = 0; k < cubes; ++k) add(number(k), 1.0, 0.0, k + 0.5);
        const double off = random.in(-0.2, 0.2);
        add("heavy", ratio, off, cubes + 0.5 + random.in(0.0, 0.2));
        tests::Run run = run_of(scene, {1, 60});
        run.advance(3.0);
        INFO("trial " << trial << ", " << cubes << " cubes, " << ratio << " kg");
        CHECK(run.measurements.max_penetration() < 1e-4);
        const Vector3 end = run.simulation.scene().world.bodies.back().position;
        CHECK(std::abs(end.x() - off) < 0.01);
        CHECK(std::abs(end.y() - (cubes + 0.5)) < 0.003);
    }
}
