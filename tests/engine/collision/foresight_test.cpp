// Which bodies meet within a step by their own motion.
#include "engine/collision/detector.h"
#include "tests/catch.h"
#include "tests/engine/contact_scene.h"

using namespace pushfactor::engine;
using namespace pushfactor::engine::collision;
using pushfactor::tests::ContactScene;

namespace {

constexpr double dt = 1.0 / 60.0;
constexpr Detection detection{.margin = 0.01};

struct Found {
    Foresight foresight;
    Detector detector;
    std::size_t points = 0;
};

// The contact points of the scene as it is, of all touches.
std::size_t points_of(const ContactScene& scene) {
    Found found;
    found.foresight.look_ahead(scene.colliders, scene.world.bodies, dt);
    for (const Touch& touch :
         found.detector.detect(scene.colliders, scene.world.bodies, detection, &found.foresight)) {
        found.points += touch.points.size();
    }
    return found.points;
}

}  // namespace

TEST_CASE("a point beyond the margin takes part when the free motion closes its gap, and not otherwise") {
    for (const double speed : {0.0, 1.0, 3.0, 5.9, 6.1, 10.0}) {
        ContactScene scene;
        scene.add_ground();
        scene.add_box({1, 1, 1}, {0, 0.6, 0}, {0, -speed, 0});  // a gap of 0.1 m and a margin of 0.01 m
        INFO(speed);
        CHECK((points_of(scene) == 4) == (dt * speed > 0.09));
    }
}

TEST_CASE("bodies that fly together foresee nothing of each other") {
    ContactScene scene;
    for (int i = 0; i < 5; ++i) scene.add_box({1, 1, 1}, {1.05 * i, 0, 0}, {10, 0, 0});
    CHECK(points_of(scene) == 0);
    scene.world.bodies[0].linear_momentum.x() *= 1.4;  // the hindmost catches up by 7 cm
    CHECK(points_of(scene) == 4);
}

TEST_CASE("what moves by more than a quarter of its size, or may bounce, is left to the sweep") {
    for (const double speed : {14.0, 16.0}) {
        ContactScene scene;
        scene.add_ground();
        scene.add_ball(0.5, {0, 0.6, 0}, {0, -speed, 0});
        CHECK((points_of(scene) == 1) == (dt * speed < dangerous));
    }
    ContactScene scene;
    scene.add_ground({.friction = 0.5, .restitution = 0.5});
    scene.add_ball(0.5, {0, 0.6, 0}, {0, -10, 0});
    CHECK(points_of(scene) == 0);
}
