// Rest: which bodies may be left out of steps and which may not, what wakes them, and that the others move alike.
#include "engine/rest.h"

#include "engine/distance_constraint.h"
#include "engine/poke.h"
#include "tests/catch.h"
#include "tests/engine/contact_scene.h"

#include <algorithm>
#include <cmath>

using namespace pushfactor;
using namespace pushfactor::engine;
using tests::ContactScene;

namespace {

constexpr double dt = ContactScene::dt;

// Boxes of 1 m on top of each other; the numbers of the bodies follow each other.
void add_tower(ContactScene& scene, int count, const Vector3& foot = {0, 0, 0}) {
    for (int i = 0; i < count; ++i) scene.add_box(Vector3::Ones(), foot + Vector3(0, 0.5 + i, 0));
}

void build(ContactScene& scene, const Vector3& gravity = {0, -10, 0}) {
    scene.build(gravity);
    scene.world.rest = std::make_unique<Rest>();
}

int steps_of(double seconds) {
    return static_cast<int>(std::lround(seconds / dt));
}

StepCount advance(World& world, double seconds) {
    StepCount count;
    for (int i = 0; i < steps_of(seconds); ++i) count = world.step(dt);
    return count;
}

// The most bodies that were at rest after any step.
int most_at_rest(World& world, double seconds) {
    int most = 0;
    for (int i = 0; i < steps_of(seconds); ++i) most = std::max(most, world.step(dt).at_rest);
    return most;
}

// Five boxes on the ground that have come to rest.
void settle_tower(ContactScene& scene) {
    build(scene);
    REQUIRE(advance(scene.world, 1.0).at_rest == 5);
}

void add_ground_and_tower(ContactScene& scene) {
    scene.add_ground();
    add_tower(scene, 5);
}

double energy(const World& world) {
    return kinetic_energy(world.bodies) + potential_energy(world.bodies, {0, -10, 0});
}

// A force that acts from the start, of which it says nothing.
class Wind : public ForceSource {
  public:
    void add_forces(const ForcedBodies& bodies, double /*time*/) override {
        for (Body& body : bodies) body.force += Vector3(0.1, 0, 0);
    }
};

}  // namespace

TEST_CASE("what stands comes to rest after half a second, and takes no rows and no work from then on") {
    ContactScene scene;
    add_ground_and_tower(scene);
    build(scene);
    CHECK(most_at_rest(scene.world, Rest::spans.front().time - dt) == 0);
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
    // The push stops at the slop, where it would have gone on.
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

TEST_CASE("a touch wakes all that rest together, in the same step, and moves none of them apart from itself") {
    ContactScene scene;
    add_ground_and_tower(scene);
    scene.add_ball(0.2, {0, 100, 0});
    settle_tower(scene);
    Body& ball = scene.world.bodies.back();
    ball.position.y() = 5.25;
    ball.linear_momentum.setZero();
    const std::vector<Body> before = scene.world.bodies;
    bool touched = false;
    for (int i = 0; i < 30; ++i) {
        const StepCount count = scene.world.step(dt);
        touched = touched || count.rows(RowKind::contact) > 0;
        CHECK(count.at_rest == (touched ? 0 : 5));
        for (std::size_t body = 1; body <= 5; ++body) {
            CHECK((scene.world.bodies[body].position - before[body].position).norm() < 1e-4);
        }
    }
    CHECK(touched);
    // And with the ball lying on it, it comes to rest once more.
    CHECK(advance(scene.world, 5.0).at_rest == 6);
}

TEST_CASE("what passes at a distance neither wakes nor keeps awake, what pushes does") {
    ContactScene scene;
    scene.add_ground();
    scene.add_box(Vector3::Ones(), {0, 0.5, 0});
    // Rolls by, with a gap of a tenth of the margin.
    scene.add_ball(0.5, {-1.5, 0.5, 1.001}, {0.5, 0, 0});
    scene.world.bodies.back().angular_momentum = {0, 0, -0.1};
    build(scene);
    int margin = 0, at_rest = 0;
    for (int i = 0; i < 360; ++i) {
        const StepCount count = scene.world.step(dt);
        margin += count.rows(RowKind::contact) > 1 && count.at_rest == 1;
        at_rest = count.at_rest;
        if (i > 60) REQUIRE(count.at_rest == 1);
    }
    CHECK(margin > 60);
    CHECK(at_rest == 1);
    CHECK(scene.world.bodies[2].position.x() > 1.0);
    // And back, into it.
    scene.world.bodies[2].position.z() = 0.5;
    scene.world.bodies[2].linear_momentum.x() = -0.5;
    CHECK(most_at_rest(scene.world, 1.0 / 6.0) == 1);
    while (velocity(scene.world.bodies[1]).norm() == 0.0) {
        REQUIRE(scene.world.time() < 20.0);
        scene.world.step(dt);
    }
    CHECK(!scene.world.rest->is_at_rest(1));
}

TEST_CASE("a body at rest stops a fast one that flies through where it lies") {
    ContactScene scene;
    scene.add_ground();
    scene.add_box({0.05, 2, 2}, {0, 1, 0});
    scene.add_ball(0.1, {-3, 1, 0});
    scene.world.bodies.back().inverse_mass = 100.0;  // 10 g
    scene.world.bodies.back().inverse_inertia *= 100.0;
    build(scene, {0, -10, 0});
    Body& ball = scene.world.bodies.back();
    for (int i = 0; i < 60; ++i) {
        ball.position = {-3, 1, 0};
        ball.linear_momentum.setZero();
        scene.world.step(dt);
    }
    REQUIRE(scene.world.rest->is_at_rest(1));
    ball.position = {-1.5, 1, 0};
    ball.linear_momentum = {0.01 * 400, 0, 0};  // 6.7 m a step
    scene.world.step(dt);
    CHECK(!scene.world.rest->is_at_rest(1));
    scene.world.step(dt);
    CHECK(ball.position.x() < 0.0);
    CHECK(velocity(scene.world.bodies[1]).x() > 0.0);
}

TEST_CASE("a force that begins and one that ends wake what they act on; one that lasts lets it rest") {
    ContactScene scene;
    add_ground_and_tower(scene);
    // Too weak to move the cube on its friction.
    scene.world.forces.push_back(
        std::make_unique<PokeForce>(Poke{.body = 5, .force = {1, 0, 0}, .from = 1.0, .until = 3.0}));
    build(scene);
    const auto at_rest_at = [&](double time) {
        while (scene.world.time() < time - 0.5 * dt) scene.world.step(dt);
        return scene.world.rest->count();
    };
    CHECK(at_rest_at(0.9) == 5);
    CHECK(at_rest_at(1.1) == 0);
    CHECK(at_rest_at(2.9) == 5);
    CHECK(at_rest_at(3.1) == 0);
    CHECK(at_rest_at(4.0) == 5);
    CHECK(scene.world.bodies[5].force == Vector3(0, -10, 0));
}

TEST_CASE("a force of which its source says nothing keeps awake") {
    ContactScene scene;
    add_ground_and_tower(scene);
    scene.world.forces.push_back(std::make_unique<Wind>());
    build(scene);
    CHECK(most_at_rest(scene.world, 3.0) == 0);
}

TEST_CASE("a bar to a body that moves keeps awake, and one to a body that rests rests with it") {
    ContactScene scene;
    scene.add_ground();
    scene.add_box(Vector3::Ones(), {0, 0.5, 0});
    scene.add_box(Vector3::Ones(), {3, 0.5, 0});
    scene.add_ball(0.1, {3.01, 3, 0});
    scene.world.constraints.push_back(std::make_unique<DistanceConstraints>(
        std::vector<Distance>{{.body_a = 1, .body_b = 2, .length = 3.0}, {.body_a = 2, .body_b = 3, .length = 2.5}},
        Correction{}, true));
    build(scene);
    CHECK(most_at_rest(scene.world, 1.0) == 0);  // the ball on the bar falls over
    CHECK(advance(scene.world, 60.0).at_rest == 3);
    scene.world.bodies[1].linear_momentum = {0, 0, 2};
    scene.world.rest->wake(1);
    CHECK(scene.world.step(dt).at_rest == 0);
    CHECK(scene.world.bodies[2].linear_momentum.norm() > 0.0);
}

TEST_CASE("on a running belt nothing rests, on one that stands it does") {
    for (const double speed : {0.0, 1.0}) {
        INFO("belt at " << speed << " m/s");
        ContactScene scene;
        scene.add_plate({20, 1, 4}, {0, -0.5, 0}, {.friction = 0.5});
        scene.colliders.back().surface_velocity = {speed, 0, 0};
        add_tower(scene, 2);
        // A wall, against which the belt holds them.
        scene.add_plate({1, 10, 4}, {1.0, 5, 0}, {.friction = 0.0});
        build(scene);
        CHECK((most_at_rest(scene.world, 3.0) > 0) == (speed == 0.0));
    }
}

TEST_CASE(
    "a belt that begins to run takes along what rests on it, in the step in which it begins, and nothing else") {
    ContactScene scene;
    scene.add_plate({20, 1, 4}, {0, -0.5, 0}, {.friction = 0.5});
    scene.colliders.back().surface_velocity = {1.0, 0, 0};
    scene.colliders.back().surface_from = 3.0;
    scene.add_plate({20, 1, 4}, {0, -0.5, 10}, {.friction = 0.5});
    add_tower(scene, 2);
    add_tower(scene, 2, {0, 0, 10});
    build(scene);
    CHECK(advance(scene.world, 2.0).at_rest == 4);
    CHECK(advance(scene.world, 1.0 - dt).at_rest == 4);
    const double before = energy(scene.world);
    const Vector3 beside = scene.world.bodies[4].position;
    CHECK(scene.world.step(dt).at_rest == 2);  // what is to change wakes before it does
    CHECK(energy(scene.world) == before);
    scene.world.step(dt);
    // mu g: no jerk, and not less.
    CHECK(velocity(scene.world.bodies[2]).x() == Approx(5.0 * dt).epsilon(1e-3));
    advance(scene.world, 2.0);
    CHECK(velocity(scene.world.bodies[2]).x() == Approx(1.0).epsilon(1e-6));
    CHECK(velocity(scene.world.bodies[3]).x() == Approx(1.0).epsilon(1e-6));
    CHECK(scene.world.rest->count() == 2);
    CHECK(scene.world.bodies[4].position == beside);
}

// A ball that turns about the line through its contacts, which no friction at a point brakes, on another one that
// is held by the ground.
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
    // Woken, it goes on with what it had.
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
        // Far away, boxes that tumble for longer.
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

TEST_CASE("to come to rest and to be woken brings no energy, over and over") {
    ContactScene scene;
    scene.add_ground();
    for (int i = 0; i < 12; ++i) {
        scene.add_box({1.0, 0.5 + 0.05 * i, 1.0}, {0.1 * (i % 3), 0.6 + 0.9 * i, 0.08 * (i % 4)});
    }
    build(scene);
    // They fall and settle first.
    while (scene.world.step(dt).at_rest < 12) REQUIRE(scene.world.time() < 30.0);
    double highest = 0.0;
    const double start = energy(scene.world);
    int rested = 0;
    for (int round = 0; round < 20; ++round) {
        scene.world.rest->wake_all();
        for (int i = 0; i < 60; ++i) {
            rested += scene.world.step(dt).at_rest == 12;
            highest = std::max(highest, energy(scene.world) - start);
        }
    }
    CHECK(rested > 20);
    CHECK(highest < 1e-9 * start);
}

TEST_CASE("a heap that rests and is hit at 20 m/s spends the energy that it got, and comes to rest anew") {
    ContactScene scene;
    scene.add_ground();
    for (int i = 0; i < 10; ++i) {
        for (int k = 0; k < 4 - i / 3; ++k)
            scene.add_box({0.4, 0.3, 0.5}, {0.5 * k + 0.02 * i, 0.25 + 0.5 * i, 0.01 * k});
    }
    for (const double side : {-1.0, 1.0}) {
        scene.add_plate({0.2, 2, 6}, {side * 2, 1, 0});
        scene.add_plate({6, 2, 0.2}, {0, 1, side});
    }
    scene.add_box(Vector3::Constant(0.4), {-10, 40, 0});
    build(scene);
    Body& hammer = scene.world.bodies.back();
    const auto hold_hammer = [&] {
        hammer.position = {-10, 40, 0};
        hammer.linear_momentum.setZero();
    };
    const int boxes = static_cast<int>(scene.world.bodies.size()) - 6;
    int at_rest = 0;
    for (int i = 0; i < steps_of(60.0) && at_rest < boxes; ++i) {
        hold_hammer();
        at_rest = scene.world.step(dt).at_rest;
    }
    REQUIRE(at_rest == boxes);
    hammer.position = {0.2, 3, 0};
    hammer.linear_momentum = {0, -20, 0};
    const double before = energy(scene.world);
    double highest = 0.0;
    int least = boxes;
    for (int i = 0; i < steps_of(2.0); ++i) {
        least = std::min(least, scene.world.step(dt).at_rest);
        highest = std::max(highest, energy(scene.world));
    }
    CHECK(least < boxes);
    CHECK(highest <= before * (1.0 + 1e-9));
    CHECK(energy(scene.world) < before - 100.0);  // of the 200 J of the hit
    CHECK(advance(scene.world, 60.0).at_rest >= boxes);
}

TEST_CASE("a stack of which the lowest cube goes falls in the same step") {
    ContactScene scene;
    add_ground_and_tower(scene);
    settle_tower(scene);
    // Code that moves a body has to wake it.
    scene.world.bodies[1].position.x() += 20.0;
    scene.world.rest->wake(1);
    CHECK(scene.world.step(dt).at_rest == 0);
    for (std::size_t body = 2; body <= 5; ++body) {
        CHECK(velocity(scene.world.bodies[body]).y() == Approx(-10.0 * dt));
    }
}
