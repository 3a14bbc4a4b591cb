// What wakes resting bodies and what does not, in which step, and that neither adds energy.
#include "engine/constraints/distance_constraints.h"
#include "engine/forces/poke.h"
#include "engine/step/rest.h"
#include "tests/catch.h"
#include "tests/engine/step/rest_scene.h"

#include <algorithm>

using namespace pushfactor;
using namespace pushfactor::engine;
using namespace pushfactor::tests::resting;
using tests::ContactScene;

namespace {

// A force that acts from the start, without an announced start time.
class Wind : public ForceSource {
  public:
    void add_forces(const ForcedBodies& bodies, double /*from*/, double /*until*/) override {
        for (Body& body : bodies) body.force += Vector3(0.1, 0, 0);
    }
};

}  // namespace

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
            // New load compresses a tower in small steps, by less than the slop.
            CHECK((scene.world.bodies[body].position - before[body].position).norm() < 2e-3);
        }
    }
    CHECK(touched);
    // And with the ball lying on it, it comes to rest again.
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
    ball.linear_momentum = {0.01 * 400, 0, 0};  // 6.7 m per step
    scene.world.step(dt);
    CHECK(!scene.world.rest->is_at_rest(1));
    scene.world.step(dt);
    CHECK(ball.position.x() < 0.0);
    CHECK(velocity(scene.world.bodies[1]).x() > 0.0);
}

TEST_CASE("a force that begins and one that ends wake what they act on, one that lasts lets it rest") {
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
        // A wall that the belt holds them against.
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
    CHECK(scene.world.step(dt).at_rest == 2);  // bodies wake before the change
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

TEST_CASE("to come to rest and to be woken brings no energy, over and over") {
    for (const double gap : {0.9, 0.905, 0.915, 0.92, 0.929}) {
        ContactScene scene;
        scene.add_ground();
        for (int i = 0; i < 12; ++i) {
            scene.add_box({1.0, 0.5 + 0.05 * i, 1.0}, {0.1 * (i % 3), 0.6 + gap * i, 0.08 * (i % 4)});
        }
        build(scene);
        // They fall and settle first.
        while (scene.world.step(dt).at_rest < 12) REQUIRE(scene.world.time() < 30.0);
        int rested = 0;
        const auto highest_in = [&](int rounds) {
            const double start = energy(scene.world);
            double highest = 0.0;
            for (int round = 0; round < rounds; ++round) {
                scene.world.rest->wake_all();
                for (int i = 0; i < 60; ++i) {
                    rested += scene.world.step(dt).at_rest == 12;
                    highest = std::max(highest, energy(scene.world) - start);
                }
            }
            return highest / start;
        };
        INFO("gap " << gap);
        // The first time takes away what the solver had left of overlaps when they came to rest: nanometres.
        CHECK(highest_in(1) < 1e-7);
        CHECK(highest_in(19) < 1e-9);
        CHECK(rested > 20);
    }
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
    // Code that moves a body must wake it.
    scene.world.bodies[1].position.x() += 20.0;
    scene.world.rest->wake(1);
    CHECK(scene.world.step(dt).at_rest == 0);
    for (std::size_t body = 2; body <= 5; ++body) {
        CHECK(velocity(scene.world.bodies[body]).y() == Approx(-10.0 * dt));
    }
}
