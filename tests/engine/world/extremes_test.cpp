// Extreme sizes, positions and initial states: defined results everywhere.
#include "tests/catch.h"
#include "tests/engine/contact_scene.h"

#include <cmath>

using namespace pushfactor::engine;
using pushfactor::tests::ContactScene;

namespace {

// Five cubes of `edge` on the ground through `origin`, overlapping by 0.01 %.
ContactScene stack_of_five(double edge, const Vector3& origin) {
    ContactScene scene;
    scene.add_ground().position = origin;
    for (int i = 0; i < 5; ++i) {
        // Slightly offset, so that no symmetry helps.
        const Vector3 place(0.003 * i, 0.5 + i * (1.0 - 1e-4), -0.002 * i);
        scene.add_box(Vector3::Constant(edge), origin + edge * place);
    }
    scene.build();
    return scene;
}

}  // namespace

TEST_CASE("a stack of five rests however far from the origin it stands") {
    for (const double distance : {0.0, 1e3, 1e5, 1e6}) {
        for (const Vector3& direction : {Vector3(1, 0, 1), Vector3(0, 1, 0)}) {
            const Vector3 origin = distance * direction;
            ContactScene scene = stack_of_five(1.0, origin);
            const auto seen = scene.watch(600);
            INFO(origin.transpose());
            CHECK(seen.speed_at_end < 1e-6);
            CHECK(seen.penetration < 0.002);
            CHECK((scene.world.bodies[5].position - origin - Vector3(0.012, 4.5, -0.008)).norm() < 1e-3);
        }
    }
}

TEST_CASE("stacks of cubes from a millimetre to a kilometre rest, and penetrate in proportion to their size") {
    for (const double edge : {1e-3, 1e-2, 1e3}) {
        ContactScene scene = stack_of_five(edge, Vector3::Zero());
        const auto seen = scene.watch(600);
        INFO(edge);
        // The smaller the cubes, the faster an unsolved stack falls over: by a factor of 1.7 per step at 1 cm.
        CHECK(seen.speed_at_end < 1e-4 * std::sqrt(10.0 * edge));
        CHECK(seen.penetration < 0.002 * edge);
        CHECK((scene.world.bodies[5].position / edge - Vector3(0.012, 4.5, -0.008)).norm() < 1e-3);
    }
}

TEST_CASE("bodies with one centre separate and come to rest") {
    using Add = void (*)(ContactScene&);
    const Add ball = [](ContactScene& scene) { scene.add_ball(0.5, {0, 0.5, 0}); };
    const Add cube = [](ContactScene& scene) { scene.add_box(Vector3::Ones(), {0, 0.5, 0}); };
    const Add slab = [](ContactScene& scene) { scene.add_box({1, 0.6, 0.4}, {0, 0.5, 0}); };
    const std::vector<std::vector<Add>> cases{{ball, ball}, {cube, cube}, {ball, cube}, {cube, ball}, {slab, cube}};
    for (std::size_t i = 0; i < cases.size(); ++i) {
        ContactScene scene;
        scene.add_ground();
        for (const Add& add : cases[i]) add(scene);
        scene.build();
        const auto seen = scene.watch(600);
        INFO("case " << i);
        // A ball on a ball is an inverted pendulum: rounding errors grow within ten seconds.
        CHECK(seen.speed_at_end < (i == 0 ? 1e-4 : 1e-6));
        CHECK(scene.penetration() < 0.0021);
        CHECK((scene.world.bodies[1].position - scene.world.bodies[2].position).norm() > 0.7);
    }
}

TEST_CASE("static bodies make no rows among themselves, however they overlap") {
    ContactScene scene;
    scene.add_ground();
    scene.add_plate(Vector3::Ones());
    scene.add_plate(Vector3::Ones(), {0, 0.3, 0});
    scene.add(static_body({0, 0.1, 0}), collision::Sphere{0.5});
    scene.build();
    CHECK(scene.world.step(ContactScene::dt).rows() == 0);
    CHECK(scene.world.bodies[2].position == Vector3(0, 0.3, 0));
}
