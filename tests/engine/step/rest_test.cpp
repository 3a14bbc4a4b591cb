// Rest: which bodies may be left out of steps and which may not, with the same motion of the others.
#include "engine/step/rest.h"

#include "engine/base/constants.h"
#include "engine/constraints/distance_constraints.h"
#include "tests/catch.h"
#include "tests/engine/step/rest_scene.h"

#include <cmath>

using namespace pushfactor;
using namespace pushfactor::engine;
using namespace pushfactor::tests::resting;
using tests::ContactScene;

TEST_CASE("what stands comes to rest after half a second, and takes no rows and no work from then on") {
    ContactScene scene;
    add_ground_and_tower(scene);
    build(scene);
    CHECK(most_at_rest(scene.world, constants::rest::time - dt) == 0);
    CHECK(most_at_rest(scene.world, 3 * dt) == 5);
    const std::vector<Body> before = scene.world.bodies;
    for (int i = 0; i < 100; ++i) {
        const StepCount count = scene.world.step(dt);
        CHECK(count.at_rest == 5);
        CHECK(count.rows() == 0);
        CHECK(count.islands == 0);
        CHECK(count.multiply_adds == 0.0);
    }
    CHECK(state_hash(scene.world.bodies) == state_hash(before));
    CHECK(max_speed(scene.world.bodies) == 0.0);
}

TEST_CASE("overlaps that the single-frame push still parts keep their island awake, although nothing has a speed") {
    ContactScene scene;
    scene.add_ground();
    scene.add_box(Vector3::Ones(), {0, 0.45, 0});
    build(scene);
    while (scene.world.step(dt).at_rest == 0) REQUIRE(scene.world.time() < 10.0);
    // The push stops at the slop, as it does for awake bodies.
    CHECK(scene.penetration() < 0.0025);
}

TEST_CASE("nothing hangs in the air: at its highest point, on a slope that is too steep, on a slow roll or tip") {
    SECTION("a pendulum of 400 m, which stays near its highest point for long") {
        ContactScene scene;
        scene.add(static_body(Vector3::Zero()), collision::Sphere{0.1});
        const Vector3 place = 400.0 * Vector3(std::sin(0.02), -std::cos(0.02), 0);
        scene.add_ball(1.0, place);
        scene.world.constraints.push_back(std::make_unique<DistanceConstraints>(
            std::vector<Distance>{{.body_a = 0, .body_b = 1, .length = 400.0}}, Correction{}, true));
        build(scene);
        CHECK(most_at_rest(scene.world, 60.0) == 0);
    }
    SECTION("a pendulum that swings by less than a fiftieth of its size") {
        for (const double offset : {0.001, 0.006}) {
            ContactScene scene;
            scene.add(static_body(Vector3::Zero()), collision::Sphere{0.1});
            scene.add_ball(0.5, {offset, -1.0, 0});
            scene.world.constraints.push_back(std::make_unique<DistanceConstraints>(
                std::vector<Distance>{{.body_a = 0, .body_b = 1, .length = std::hypot(offset, 1.0)}}, Correction{},
                true));
            build(scene);
            CHECK(most_at_rest(scene.world, 30.0) == 0);
        }
    }
    SECTION("a ball thrown straight up") {
        ContactScene scene;
        scene.add_ground();
        scene.add_ball(0.5, {0, 0.5, 0}, {0, 30, 0});
        build(scene);
        CHECK(most_at_rest(scene.world, 5.5) == 0);
    }
    SECTION("a box that slides from 0, pulled by a thousandth of its weight more than friction holds") {
        ContactScene scene;
        scene.add_ground({.friction = 0.1});
        scene.add_box(Vector3::Ones(), {0, 0.5, 0}, Vector3::Zero(), {.friction = 0.1});
        build(scene, {1.01, -10, 0});
        CHECK(most_at_rest(scene.world, 40.0) == 0);
    }
    SECTION("a ball on a slope of 1 in 1000") {
        ContactScene scene;
        scene.add_ground();
        scene.add_ball(0.5, {0, 0.5, 0});
        build(scene, {0.01, -10, 0});
        CHECK(most_at_rest(scene.world, 40.0) == 0);
    }
    SECTION("a board that begins to tip over an edge, from 1 mm beyond its balance") {
        ContactScene scene;
        scene.add_plate({1, 1, 1}, {-0.501, 0, 0});
        scene.add_box({2, 0.1, 1}, {0, 0.55, 0});
        build(scene);
        CHECK(most_at_rest(scene.world, 0.6) == 0);
    }
    SECTION("two boxes that lie on each other and fall, with a gravity of 1e-5 m/s^2") {
        ContactScene scene;
        add_tower(scene, 2, {0, 10, 0});
        build(scene, {0, -1e-5, 0});
        CHECK(most_at_rest(scene.world, 5.0) == 0);
    }
}

// A ball that spins about the line through its contacts, which friction at a point does not brake, on another one
// that is held by the ground.
void add_turning_ball(ContactScene& scene, double rate) {
    scene.add_ground();
    scene.add_ball(0.5, {0, 0.5, 0});
    scene.add_ball(0.5, {0, 1.5, 0});
    scene.world.bodies[2].angular_momentum = {0, 0.1 * rate, 0};  // 2/5 m r^2 = 0.1 kg m^2
}

TEST_CASE("a ball that turns in its place for ever rests with what it lies on, and goes on turning as it would") {
    const double rate = 0.3;
    ContactScene scene, awake;
    for (ContactScene* one : {&scene, &awake}) {
        add_turning_ball(*one, rate);
        build(*one);
    }
    awake.world.rest = nullptr;
    const double before = energy(scene.world);
    const StepCount count = advance(scene.world, 2.0);
    CHECK(count.at_rest == 2);
    CHECK(count.rows() == 0);
    CHECK(angular_velocity(scene.world.bodies[2]).y() == Approx(rate).epsilon(1e-9));
    CHECK(scene.world.bodies[1].angular_momentum.isZero(0.0));
    CHECK(energy(scene.world) <= before);
    CHECK(energy(scene.world) > before - 1e-9);
    advance(awake.world, 2.0);
    const auto turned_apart = [&] {
        return scene.world.bodies[2].orientation.angularDistance(awake.world.bodies[2].orientation);
    };
    CHECK(turned_apart() < 1e-9);
    CHECK(2.0 * rate == Approx(Quaternion::Identity().angularDistance(scene.world.bodies[2].orientation)));
    // Once woken it continues with its former momentum.
    scene.world.rest->wake(1);
    CHECK(scene.world.step(dt).at_rest == 0);
    awake.world.step(dt);
    CHECK(turned_apart() < 1e-9);
}

TEST_CASE("a ball whose spin friction brakes does not rest before it has ended, nor does a box that turns") {
    ContactScene scene;
    scene.add_ground();
    scene.add_ball(0.5, {0, 0.5, 0}, {0, 0, 0}, {.friction = 0.01});
    scene.world.bodies[1].angular_momentum = {0, 0, -1.0};  // 10 rad/s; mu g for some seconds until it rolls
    scene.add_box({1, 1, 1}, {5, 0.5, 0}, {0, 0, 0}, {.friction = 0.0});
    scene.world.bodies[2].angular_momentum = {0, 0.05, 0};
    build(scene);
    CHECK(most_at_rest(scene.world, 10.0) == 0);
}

TEST_CASE("a ball that turns at rest in a saved state goes on turning in the next world") {
    ContactScene scene, next;
    for (ContactScene* one : {&scene, &next}) {
        add_turning_ball(*one, 0.5);
        build(*one);
    }
    advance(scene.world, 2.0);
    REQUIRE(scene.world.rest->turning().size() == 1);
    next.world.bodies = scene.world.bodies;
    next.world.rest->set_memory(scene.world.rest->memory(), next.world.bodies);
    for (ContactScene* one : {&scene, &next}) advance(one->world, 1.0);
    CHECK(next.world.bodies[2].orientation.coeffs() == scene.world.bodies[2].orientation.coeffs());
}

TEST_CASE("what is awake has the same bits with and without something at rest beside it") {
    std::uint64_t hash[2];
    for (const bool rests : {false, true}) {
        ContactScene scene;
        add_ground_and_tower(scene);
        // Far away boxes that tumble for longer.
        for (int i = 0; i < 6; ++i) {
            scene.add_box(Vector3::Ones(), {50.0 + 0.3 * i, 3.0 + 1.5 * i, 0.2 * i}, {1.0, 0, 0.5});
        }
        build(scene);
        if (!rests) scene.world.rest = nullptr;
        const int at_rest = advance(scene.world, 1.5).at_rest;
        CHECK(at_rest == (rests ? 5 : 0));
        hash[rests] = state_hash(std::span(scene.world.bodies).subspan(6));
    }
    CHECK(hash[0] == hash[1]);
}
