// Heaps in small steps on bodies that move.
#include "tests/catch.h"
#include "tests/engine/world/moved_scene.h"

using namespace pushfactor::engine;
using namespace pushfactor::tests;

TEST_CASE("a heap in small steps goes up and down with what it lies on") {
    for (const double speed : {1.0, -0.3}) {
        ContactScene scene;
        add_under(scene, Under::plate);
        for (int layer = 0; layer < 3; ++layer) {
            for (int i = 0; i < 4; ++i) {
                scene.add_box(Vector3::Constant(0.5), {0.55 * (i % 2), 0.25 + 0.5 * layer, 0.55 * (i / 2)});
            }
        }
        scene.add_box({1.2, 0.2, 1.2}, {0.27, 1.6, 0.27});
        move(scene, 0, {.velocity = {0, speed, 0}}, {.from = 0.5});
        scene.build();
        scene.world.small_steps = std::make_unique<SmallSteps>();
        scene.world.solver = solvers::make_solver("pgs");
        int small = 0;
        for (int i = 0; i < 120; ++i) small += scene.world.step(ContactScene::dt).islands_in_small_steps;
        INFO(speed);
        CHECK(small > 10);
        CHECK(scene.world.bodies.back().position.y() == Approx(1.6 + 1.5 * speed).margin(0.005));
        CHECK(velocity(scene.world.bodies.back()).y() == Approx(speed).margin(0.01));
        CHECK(scene.penetration() < 0.005);
    }
}

TEST_CASE("small steps push a heap out of a plate that goes up or down as out of one that stands") {
    std::vector<double> overlaps;
    for (const double speed : {0.0, 1.0, -0.3}) {
        ContactScene scene;
        add_under(scene, Under::plate);
        for (int i = 0; i < 9; ++i) scene.add_box(Vector3::Constant(0.5), {0.5 * (i % 3), 0.2, 0.5 * (i / 3)});
        for (Body& body : scene.world.bodies) {
            if (!body.is_static()) body.linear_momentum.y() = speed;
        }
        move(scene, 0, {.velocity = {0, speed, 0}});
        scene.build();
        scene.world.small_steps = std::make_unique<SmallSteps>(SmallStepDivision{.steps = 16, .sweeps = 4});
        scene.world.solver = solvers::make_solver("pgs");
        int small = 0;
        for (int i = 0; i < 5; ++i) small += scene.world.step(ContactScene::dt).islands_in_small_steps;
        CHECK(small > 0);
        overlaps.push_back(scene.penetration());
    }
    CHECK(overlaps[0] < 0.03);
    CHECK(overlaps[1] == Approx(overlaps[0]).margin(1e-4));
    CHECK(overlaps[2] == Approx(overlaps[0]).margin(1e-4));
}
