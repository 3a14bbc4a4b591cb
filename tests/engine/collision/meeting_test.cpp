// Which bodies meet within a step by their own motion.
#include "tests/catch.h"
#include "tests/engine/contact_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace pushfactor::engine;
using namespace pushfactor::engine::collision;
using pushfactor::tests::ContactScene;

namespace {

constexpr double dt = ContactScene::dt;

// The contact points of the scene as it is, of all touches.
std::size_t points_of(ContactScene& scene) {
    std::size_t points = 0;
    for (const Touch& touch : scene.touches()) points += touch.points.size();
    return points;
}

}  // namespace

TEST_CASE("a face beyond the margin takes part when the free motion brings it to the other, and not otherwise") {
    for (const double speed : {1.0, 3.0, 5.9, 6.1, 10.0, 100.0}) {
        ContactScene scene;
        scene.add_ground();
        scene.add_box({1, 1, 1}, {0, 0.6, 0}, {0, -speed, 0});  // a gap of 0.1 m
        INFO(speed);
        CHECK((points_of(scene) >= 4) == (dt * speed > 0.1 - 0.01));  // it meets, or ends in the margin
        for (const Touch& touch : scene.touches())
            CHECK(touch.time == Approx(std::min(dt, 0.1 / speed)).epsilon(1e-4));
    }
}

TEST_CASE("bodies that fly together meet nothing of each other") {
    ContactScene scene;
    for (int i = 0; i < 5; ++i) scene.add_box({1, 1, 1}, {1.05 * i, 0, 0}, {10, 0, 0});
    CHECK(points_of(scene) == 0);
    scene.world.bodies[0].linear_momentum.x() *= 1.4;  // the hindmost catches up by 7 cm
    CHECK(points_of(scene) == 4);
}

TEST_CASE("what is in the margin and does not come closer stays near, what passes has no contact") {
    ContactScene scene;
    scene.add_ball(0.5, {0, 0, 0});
    scene.add_ball(0.5, {0, 1.005, 0}, {0, 0.1, 0});  // half of the margin away, and leaving
    REQUIRE(scene.touches().size() == 1);
    CHECK(scene.touches().front().points.front().gap == Approx(0.005));
    scene.world.bodies[1].position = {-0.05, 1.004, 0};  // towards the first, and past it by 4 mm
    scene.world.bodies[1].linear_momentum = {20, 0, 0};
    CHECK(scene.touches().empty());
    scene.world.bodies[1].position = {-0.05, 0.9999, 0};
    REQUIRE(scene.touches().size() == 1);
    CHECK(scene.touches().front().time > 0.0);
}

TEST_CASE("a prism of 64 corners that lands has more points than one that lies") {
    for (const double speed : {0.0, 7.0}) {
        std::vector<Vector3> vertices;
        std::vector<std::vector<int>> faces(2);
        for (int k = 0; k < 64; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / 64;
            for (const double y : {-0.0125, 0.0125})
                vertices.emplace_back(0.5 * std::cos(angle), y, 0.5 * std::sin(angle));
            faces[0].push_back(2 * k);
            faces[1].insert(faces[1].begin(), 2 * k + 1);
            const int next = 2 * ((k + 1) % 64);
            faces.push_back({2 * k, 2 * k + 1, next + 1, next});
        }
        const Shape coin = Polyhedron{std::make_shared<PolyhedronMesh>(vertices, faces)};
        ContactScene scene;
        scene.add_ground();
        scene.add(solid_body(1.0, Vector3(0.0625, 0.125, 0.0625), {0, 0.0125 + 0.003 * speed, 0}), coin);
        scene.world.bodies[1].linear_momentum = {0, -speed, 0};
        const std::size_t points = points_of(scene);
        CHECK((speed > 0.0 ? points > 16 : points == 4));
    }
}
