// What rests on a moved body, or hangs on one: when it wakes.
#include "engine/constraints/distance_constraints.h"
#include "engine/constraints/joint_constraints.h"
#include "engine/step/rest.h"
#include "tests/catch.h"
#include "tests/engine/world/moved_scene.h"

#include <cmath>

using namespace pushfactor::engine;
using namespace pushfactor::tests;

TEST_CASE("a stack at rest wakes in the step in which its table starts to move, and goes along without a jerk") {
    ContactScene scene;
    add_under(scene, Under::plate);
    for (int i = 0; i < 3; ++i) scene.add_box(Vector3::Ones(), {0, 0.5 + i, 0});
    scene.add_box(Vector3::Ones(), {50, 0.5, 0});
    scene.add_plate({4, 1, 4}, {50, -0.5, 0});
    // Begins slowly: the lowest point of a sinusoid, half a metre to and fro.
    const Place start = place_of(scene.world.bodies[0]);
    scene.world.move(0, std::make_unique<Oscillation>(start, Vector3(0.25, 0, 0), 0.25, -0.5 * pi,
                                                      PathTimes{.from = 2.0, .until = 4.0}));
    scene.build();
    scene.world.rest = std::make_unique<Rest>();
    for (int i = 1; i <= 120; ++i) scene.world.step(ContactScene::dt);
    REQUIRE(scene.world.rest->count() == 4);
    double fastest_change = 0.0;
    Vector3 before = Vector3::Zero();
    for (int i = 0; i < 120; ++i) {
        const StepCount count = scene.world.step(ContactScene::dt);
        REQUIRE(count.at_rest == 1);  // the cube elsewhere
        const Vector3 now = velocity(scene.world.bodies[3]);
        fastest_change = std::max(fastest_change, (now - before).norm() / ContactScene::dt);
        before = now;
        const double offset = scene.world.bodies[0].position.x();
        for (std::size_t k = 1; k <= 3; ++k) {
            CHECK(scene.world.bodies[k].position.x() == Approx(offset).margin(1e-6));
        }
    }
    CHECK(fastest_change < 1.01 * 0.25 * std::pow(2 * pi * 0.25, 2));
    // The table stands still again, and so do they.
    for (int i = 0; i < 60; ++i) scene.world.step(ContactScene::dt);
    CHECK(scene.world.rest->count() == 4);
    CHECK(scene.world.bodies[3].position.x() == Approx(0.5).margin(1e-6));
}

TEST_CASE("a body does not rest on one that moves, with or without friction, nor hung on one") {
    for (const double friction : {0.0, 0.5}) {
        ContactScene scene;
        add_under(scene, Under::plate, {.friction = friction});
        scene.add_box(Vector3::Ones(), {0, 0.5, 0}, {0, 0, 0}, {.friction = friction});
        move(scene, 0, {.velocity = {0.001, 0, 0}});
        scene.build();
        scene.world.rest = std::make_unique<Rest>();
        for (int i = 0; i < 240; ++i) REQUIRE(scene.world.step(ContactScene::dt).at_rest == 0);
    }
}

namespace {

const Correction at_once{PushKind::persistent, 1.0};

std::unique_ptr<ConstraintSource> two_bars() {
    const std::vector bars{Distance{.body_a = 0, .body_b = 1}, Distance{.body_a = 3, .body_b = 2}};
    return std::make_unique<DistanceConstraints>(bars, at_once, true);
}

std::unique_ptr<ConstraintSource> two_hinges() {
    const std::vector hinges{Joint{.body_a = 0, .body_b = 1, .point_b = {0, 1, 0}, .hinge = Hinge{}},
                             Joint{.body_a = 3, .body_b = 2, .point_a = {0, 1, 0}, .hinge = Hinge{}}};
    return std::make_unique<JointConstraints>(hinges, at_once, true);
}

}  // namespace

TEST_CASE("what hangs at rest wakes in the step in which the point that it hangs on starts to move") {
    const bool hinges = GENERATE(false, true);
    INFO("hinges " << hinges);
    World world;
    world.bodies = {static_body({0, 2, 0}), ball_body(1.0, 0.1, {0, 1, 0}), static_body({5, 2, 0}),
                    ball_body(1.0, 0.1, {5, 1, 0})};
    world.forces.push_back(std::make_unique<Gravity>(Vector3(0, -g, 0)));
    world.constraints.push_back(hinges ? two_hinges() : two_bars());
    world.solver = solvers::make_solver("auto");
    world.termination = {.iterations = 25, .tolerance_high = 1e-8, .tolerance_low = 1e-10};
    world.rest = std::make_unique<Rest>();
    world.move(0, std::make_unique<SteadyPath>(place_of(world.bodies[0]), Motion{{0, 1, 0}, {0, 0, 0}},
                                               PathTimes{.from = 1.0}));
    for (int i = 0; i < 60; ++i) world.step(ContactScene::dt);
    REQUIRE(world.rest->count() == 2);
    CHECK(world.step(ContactScene::dt).at_rest == 1);
    CHECK(world.rest->is_at_rest(3));
    CHECK(velocity(world.bodies[1]).y() == Approx(1.0).epsilon(1e-6));
}
