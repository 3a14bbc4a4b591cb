// Impacts in the order in which they happen within a step.
#include "engine/impacts/impacts.h"

#include "engine/constraints/distance_constraints.h"
#include "engine/energy_account.h"
#include "tests/catch.h"
#include "tests/engine/contact_scene.h"
#include "tests/random.h"

#include <algorithm>
#include <array>
#include <cmath>

using namespace pushfactor::engine;
using namespace pushfactor::tests;

namespace {

constexpr double radius = 0.1;
const Surface elastic{.friction = 0.0, .restitution = 1.0};

// Balls along x with equal gaps, without gravity; the first one comes at 10 m/s.
ContactScene row_of_balls(int count, double gap, const Surface& surface = elastic) {
    ContactScene scene;
    for (int i = 0; i < count; ++i) {
        scene.add_ball(radius, {i * (2.0 * radius + gap), 0, 0}, {i == 0 ? 10.0 : 0.0, 0, 0}, surface);
    }
    scene.build(Vector3::Zero());
    return scene;
}

double speed_of(const ContactScene& scene, int ball) {
    return velocity(scene.world.bodies[static_cast<std::size_t>(ball)]).x();
}

double energy_of(const World& world) {
    return kinetic_energy(world.bodies);
}

}  // namespace

TEST_CASE("a blow passes along a row of equal elastic balls, at any distance and any step") {
    for (const int count : {2, 3, 10, 50}) {
        for (const double gap : {0.0, 1e-9, 0.001, 0.03, 0.3, 1.0}) {
            for (const double step : {1.0 / 7.0, 1.0 / 60.0, 1.0 / 240.0}) {
                ContactScene scene = row_of_balls(count, gap);
                const double arrives = 0.1 * gap * (count - 1);
                const int steps = static_cast<int>(std::ceil((arrives + 0.01) / step));
                int impacts = 0;
                for (int n = 0; n < steps; ++n) {
                    scene.world.step(step);
                    impacts += scene.world.impacts->count();
                }
                INFO(count << " balls, gap " << gap << ", step " << step);
                CHECK(impacts == count - 1);
                for (int i = 0; i + 1 < count; ++i) REQUIRE(std::abs(speed_of(scene, i)) < 1e-6);
                CHECK(speed_of(scene, count - 1) == Approx(10.0).epsilon(1e-12));
                // The last one has flown on since the blow arrived.
                const double end = (count - 1) * (2.0 * radius + gap) + 10.0 * (steps * step - arrives);
                CHECK(scene.world.bodies.back().position.x() == Approx(end).margin(1e-6));
            }
        }
    }
}

TEST_CASE("each impact of a row of balls has the restitution of its pair") {
    const double epsilon = 0.6;
    ContactScene scene = row_of_balls(4, 0.01, {.friction = 0.0, .restitution = epsilon});
    scene.world.step(1.0 / 60.0);
    const double passed = 0.5 * (1.0 + epsilon), kept = 0.5 * (1.0 - epsilon);
    CHECK(speed_of(scene, 0) == Approx(10.0 * kept));
    CHECK(speed_of(scene, 1) == Approx(10.0 * passed * kept));
    CHECK(speed_of(scene, 2) == Approx(10.0 * passed * passed * kept));
    CHECK(speed_of(scene, 3) == Approx(10.0 * passed * passed * passed));
}

TEST_CASE("two balls that arrive at a touching row drive out two") {
    ContactScene scene;
    for (int i = 0; i < 6; ++i) {
        const double apart = i < 2 ? 0.02 : 0.0;
        scene.add_ball(radius, {2.0 * radius * i - apart, 0, 0}, {i < 2 ? 3.0 : 0.0, 0, 0}, elastic);
    }
    scene.build(Vector3::Zero());
    scene.world.step(1.0 / 60.0);
    for (int i = 0; i < 4; ++i) CHECK(std::abs(speed_of(scene, i)) < 1e-9);
    for (int i = 4; i < 6; ++i) CHECK(speed_of(scene, i) == Approx(3.0));
}

TEST_CASE(
    "a gas of elastic balls keeps its energy and none of them overlaps or leaves, however far they fly in a step") {
    Random random(5);
    for (const double paths : {0.1, 0.5, 2.0}) {  // diameters a step
        ContactScene scene;
        scene.add_closed_box(elastic);
        const double size = 0.2, speed = paths * size * 60.0;
        for (int i = 0; i < 40; ++i) {
            const Vector3 place(-2.4 + 1.2 * (i % 4), -2.4 + 1.2 * (i / 4 % 4), -2.4 + 1.2 * (i / 16));
            scene.add_ball(0.5 * size, place, speed * random.vector(-1, 1), elastic);
        }
        scene.build(Vector3::Zero());
        const double before = energy_of(scene.world);
        int impacts = 0;
        for (int n = 0; n < 300; ++n) {
            scene.world.step(1.0 / 60.0);
            impacts += scene.world.impacts->count();
            REQUIRE(energy_of(scene.world) == Approx(before).epsilon(1e-9));
            REQUIRE(scene.penetration() < 1e-5);
        }
        CHECK(impacts > 100 * paths);
    }
}

TEST_CASE("balls in a tube keep their order") {
    Random random(9);
    ContactScene scene;
    scene.add_plate({0.2, 1, 1}, {-0.2, 0, 0}, elastic);
    for (int i = 0; i < 12; ++i) {
        scene.add_ball(radius, {0.15 + 0.3 * i, 0, 0}, {random.in(-80, 80), 0, 0}, elastic);
    }
    scene.add_plate({0.2, 1, 1}, {3.8, 0, 0}, elastic);
    scene.build(Vector3::Zero());
    const double before = energy_of(scene.world);
    for (int n = 0; n < 600; ++n) {
        scene.world.step(1.0 / 60.0);
        for (std::size_t i = 2; i < 13; ++i) {
            const double apart = scene.world.bodies[i].position.x() - scene.world.bodies[i - 1].position.x();
            REQUIRE(apart > 2.0 * radius - 1e-5);
        }
    }
    CHECK(energy_of(scene.world) == Approx(before).epsilon(1e-9));
}

// A ball on a ball of three times its mass: it leaves with twice the speed, and rises to four times the height.
TEST_CASE("the upper one of two balls that fall together rises as high as their impacts say") {
    for (const double gap : {1e-3, 1e-2}) {
        for (const double step : {1.0 / 60.0, 1.0 / 240.0}) {
            ContactScene scene;
            scene.add_ground(elastic);
            Body& heavy = scene.add_ball(0.3, {0, 1.3, 0}, Vector3::Zero(), elastic);
            heavy.inverse_mass /= 3.0;
            heavy.inverse_inertia /= 3.0;
            scene.add_ball(radius, {0, 1.7 + gap, 0}, Vector3::Zero(), elastic);
            scene.build();
            double highest = 0.0;
            for (int n = 0; n < 1.5 / step; ++n) {
                scene.world.step(step);
                highest = std::max(highest, scene.world.bodies[2].position.y());
            }
            INFO("gap " << gap << ", step " << step);
            CHECK(highest - 0.7 == Approx(4.0).epsilon(0.02));
        }
    }
}

TEST_CASE("a ball leaves a moving wall with twice its speed more, and the wall has done that work") {
    ContactScene scene;
    scene.add_plate({0.2, 1, 1}, {-0.2, 0, 0}, elastic);
    scene.add_ball(radius, {0.33, 0, 0}, {-4, 0, 0}, elastic);
    scene.build(Vector3::Zero());
    scene.world.move(0, std::make_unique<SteadyPath>(Place{{-0.2, 0, 0}, Quaternion::Identity()},
                                                     Motion{{3, 0, 0}, Vector3::Zero()}, PathTimes{}));
    EnergyAccount account(Vector3::Zero());
    account.open(scene.world.bodies, ContactScene::dt);
    for (int n = 0; n < 12; ++n) {
        account.begin(scene.world.bodies);
        scene.world.step(ContactScene::dt);
        account.end(scene.world, ContactScene::dt);
    }
    CHECK(velocity(scene.world.bodies[1]).x() == Approx(10.0));
    CHECK(account.external_work() == Approx(0.5 * (100.0 - 16.0)));
    CHECK(std::abs(account.gain()) < 1e-9);
}

TEST_CASE("what holds a body takes part in its impacts: balls on bars, and a body that lies on the ground") {
    // A ball hangs on a bar along its way: it can not move, and the other one bounces back.
    ContactScene held;
    held.add(static_body({1.0, 0, 0}), collision::Sphere{0.01});
    held.add_ball(radius, {0, 0, 0}, Vector3::Zero(), elastic);
    held.add_ball(radius, {-0.25, 0, 0}, {5, 0, 0}, elastic);
    held.build(Vector3::Zero());
    held.world.constraints.push_back(std::make_unique<DistanceConstraints>(
        std::vector<Distance>{{.body_a = 0, .body_b = 1, .length = 1.0}}, Correction{}, true));
    held.world.step(ContactScene::dt);
    CHECK(velocity(held.world.bodies[2]).x() == Approx(-5.0));
    CHECK(std::abs(velocity(held.world.bodies[1]).x()) < 1e-9);

    ContactScene lies;
    lies.add_ground({.friction = 0.5});
    lies.add_box({1, 0.2, 1}, {0, 0.1, 0});
    lies.add_ball(radius, {0, 1.3, 0}, Vector3::Zero(), {.friction = 0.5, .restitution = 0.5});
    lies.build();
    double highest = 0.0;
    for (int n = 0; n < 60; ++n) {
        lies.world.step(ContactScene::dt);
        if (velocity(lies.world.bodies[2]).y() > 0.0)
            highest = std::max(highest, lies.world.bodies[2].position.y() - 0.3);
    }
    CHECK(highest == Approx(0.25).epsilon(0.01));
    CHECK(lies.world.bodies[1].position.y() == Approx(0.1).margin(1e-4));
}

TEST_CASE("a support that the body leaves is none: a light ball between heavy ones makes no energy") {
    ContactScene scene;
    scene.add_ball(radius, {-0.2, 0, 0}, Vector3::Zero(), {.friction = 0.0});
    scene.add_ball(radius, {0, 0, 0}, {1, 0, 0}, {.friction = 0.0});
    scene.add_ball(radius, {0.201, 0, 0}, Vector3::Zero(), elastic);
    scene.world.bodies[0].inverse_mass = scene.world.bodies[2].inverse_mass = 1e-4;
    scene.build(Vector3::Zero());
    const double start = energy_of(scene.world);
    for (int n = 0; n < 60; ++n) {
        scene.world.step(ContactScene::dt);
        REQUIRE(energy_of(scene.world) <= start * (1.0 + 1e-9));
    }
    CHECK(velocity(scene.world.bodies[2]).x() > 0.0);
}

// Of a light ball between heavy ones each impact loses little. As long as only the fastest one decided which others
// count, they met at one instant until the limit on impacts.
TEST_CASE("light balls between heavy ones that come to a stop do not meet for ever") {
    for (const double epsilon : {0.5, 0.6, 0.7, 0.8}) {
        ContactScene scene;
        const Surface surface{.friction = 0.0, .restitution = epsilon};
        scene.add_ground(surface);
        for (int i = 0; i < 4; ++i) {
            scene.add_ball(radius, {0, (1.0 + 2.001 * i) * radius, 0}, {0, -3, 0}, surface);
            scene.world.bodies.back().inverse_mass *= i % 2 == 0 ? 1.0 : 0.004;
            scene.world.bodies.back().linear_momentum /= i % 2 == 0 ? 1.0 : 0.004;
        }
        scene.build(Vector3::Zero());
        const double start = energy_of(scene.world);
        int most = 0;
        for (int n = 0; n < 30; ++n) {
            scene.world.step(ContactScene::dt);
            most = std::max(most, scene.world.impacts->count());
            CHECK(!scene.world.impacts->is_cut_short());
        }
        INFO("restitution " << epsilon << ", up to " << most << " impacts in a step");
        CHECK(most > 4);
        CHECK(most < 400);  // 238 to 318
        CHECK(energy_of(scene.world) < start);
        for (std::size_t i = 2; i < scene.world.bodies.size(); ++i) {
            const double apart = scene.world.bodies[i].position.y() - scene.world.bodies[i - 1].position.y();
            CHECK(apart > 2.0 * radius - 5e-4);
        }
    }
}

TEST_CASE("bodies at rest that are hit wake in that step") {
    ContactScene scene;
    scene.add_ground();
    scene.add_box({0.4, 0.4, 0.4}, {0, 0.2, 0});
    scene.add_ball(radius, {-6, 0.2, 0}, {5, 0, 0}, {.friction = 0.0, .restitution = 0.8});
    scene.build({0, -1e-3, 0});
    scene.world.rest = std::make_unique<Rest>();
    bool rested = false;
    for (int n = 0; n < 90; ++n) {
        scene.world.step(ContactScene::dt);
        rested = rested || scene.world.rest->is_at_rest(1);
    }
    CHECK(rested);
    CHECK(!scene.world.rest->is_at_rest(1));
    CHECK(velocity(scene.world.bodies[1]).x() > 1.0);
}

TEST_CASE("a ball that hits two at once, or both sides of a groove, goes straight back") {
    for (const bool swapped : {false, true}) {
        ContactScene scene;
        scene.add_ball(0.5, {-3, 0, 0}, {10, 0, 0}, elastic);
        for (const double side : swapped ? std::array{-0.5, 0.5} : std::array{0.5, -0.5})
            scene.add_ball(0.5, {0, 0, side}, {0, 0, 0}, elastic);
        scene.build(Vector3::Zero());
        for (int n = 0; n < 60; ++n) scene.world.step(ContactScene::dt);
        // Both impulses together reverse the approach of both pairs.
        CHECK((velocity(scene.world.bodies[0]) - Vector3(-2, 0, 0)).norm() < 1e-9);
        const double side = swapped ? -1.0 : 1.0;
        CHECK((velocity(scene.world.bodies[1]) - Vector3(6, 0, side * std::sqrt(12.0))).norm() < 1e-9);
        CHECK((velocity(scene.world.bodies[2]) - Vector3(6, 0, -side * std::sqrt(12.0))).norm() < 1e-9);
    }
    for (const double restitution : {0.3, 0.9}) {
        const Surface surface{.friction = 0.0, .restitution = restitution};
        ContactScene scene;
        for (const double angle : {0.7, -0.7}) {
            scene.add_ground(surface);
            scene.world.bodies.back().orientation = Eigen::AngleAxisd(angle, Vector3::UnitZ());
        }
        scene.add_ball(0.3, {0, 2, 0}, {0, 0, 0}, surface);
        scene.build({0, -9.81, 0});
        for (int n = 0; n < 120; ++n) scene.world.step(ContactScene::dt);
        CHECK(std::abs(scene.world.bodies[2].position.x()) < 1e-9);
    }
}

TEST_CASE("a plank that lands flat on two blocks does not turn") {
    const Surface surface{.friction = 0.5, .restitution = 0.5};
    ContactScene plank;
    for (const double x : {-1.0, 1.0}) plank.add_plate({1, 1, 1}, {x, 0, 0}, surface);
    plank.add_box({3, 0.2, 1}, {0, 1.6, 0}, {0, 0, 0}, surface);
    plank.build({0, -9.81, 0});
    for (int n = 0; n < 120; ++n) {
        plank.world.step(ContactScene::dt);
        CHECK(angular_velocity(plank.world.bodies[2]).norm() < 1e-9);
    }
}
