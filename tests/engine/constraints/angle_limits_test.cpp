// Limits of hinges.
#include "tests/catch.h"
#include "tests/engine/constraints/linkage.h"

using namespace pushfactor::engine;
using namespace pushfactor::tests;
using Catch::Matchers::WithinAbs;

TEST_CASE("limits stop a hinge where they are, on either side, and give it no energy") {
    for (const Correction& correction : {whole, Correction{PushKind::single_frame, 0.2}}) {
        for (const double side : {1.0, -1.0}) {
            Linkage linkage = pendulum(side * 1.4);
            linkage.joints[0].hinge->limits = side > 0.0 ? AngleLimits{0.5, 2.0} : AngleLimits{-2.0, -0.5};
            linkage.build(correction);
            linkage.account.open(linkage.world.bodies, 1.0 / 60.0);
            double last = linkage.energy();
            for (int i = 0; i < 240; ++i) {
                linkage.step(1.0 / 60.0);
                REQUIRE(side * linkage.angle() > 0.5 - 1e-4);
                REQUIRE(linkage.account.gain() < 0.05);
            }
            CHECK_THAT(side * linkage.angle(), WithinAbs(0.5, 1e-5));
            CHECK(std::abs(linkage.speed(1)) < 1e-5);
            CHECK(linkage.energy() < last);
        }
    }
}

TEST_CASE("a hinge outside its limits is pushed back, with no speed left by the single-frame push") {
    Linkage linkage = pendulum(1.0);
    linkage.joints[0].hinge->limits = AngleLimits{-0.5, 0.5};
    linkage.build({PushKind::single_frame, 0.2}, false);
    double last = 1.0;
    for (int i = 0; i < 100; ++i) {
        linkage.step(1.0 / 60.0);
        CHECK(linkage.angle() <= last + 1e-12);
        last = linkage.angle();
    }
    CHECK_THAT(linkage.angle(), WithinAbs(0.5, 1e-6));
    CHECK(std::abs(linkage.speed(1)) < 1e-9);
}

TEST_CASE("equal limits weld: two bodies fly and turn as one") {
    Linkage linkage;
    const int a = linkage.add(box_body(1.0, {1, 0.4, 0.3}, {-0.5, 0, 0}));
    const int b = linkage.add(box_body(3.0, {1, 0.8, 0.3}, {0.5, 0, 0}));
    linkage.join(a, b, Vector3::Zero()).hinge->limits = AngleLimits{0.0, 0.0};
    linkage.world.bodies[1].angular_momentum = {0.3, 0.2, 0.5};
    linkage.build(whole, false);
    for (int i = 0; i < 600; ++i) REQUIRE(linkage.step(1.0 / 240.0).rows(RowKind::limit) == 1);
    CHECK(linkage.world.bodies[1].orientation.angularDistance(linkage.world.bodies[2].orientation) < 1e-4);
    CHECK((angular_velocity(linkage.world.bodies[1]) - angular_velocity(linkage.world.bodies[2])).norm() < 1e-3);
    CHECK(angular_velocity(linkage.world.bodies[1]).norm() > 0.1);
}

TEST_CASE("a motor stops at a limit and holds there") {
    Linkage linkage = pendulum(0.0);
    linkage.joints[0].hinge->motor = Motor{.speed = 1.0, .max_torque = 20.0};
    linkage.joints[0].hinge->limits = AngleLimits{-1.0, 1.2};
    linkage.build();
    for (int i = 0; i < 300; ++i) linkage.step(1.0 / 60.0);
    CHECK_THAT(linkage.angle(), WithinAbs(1.2, 1e-6));
    CHECK(std::abs(linkage.speed(1)) < 1e-9);
}

TEST_CASE("a motor without largest torque stops at a limit, at any speed, and turns back when its sign changes") {
    for (const double speed : {1.0, 7.0, 100.0}) {
        Linkage linkage = pendulum(0.0);
        linkage.joints[0].hinge->motor = Motor{.speed = speed};
        linkage.joints[0].hinge->limits = AngleLimits{-1.0, 1.2};
        linkage.build();
        for (int i = 0; i < 200; ++i) {
            linkage.step(1.0 / 60.0);
            REQUIRE(linkage.angle() < 1.2 + 1e-4);
        }
        CHECK_THAT(linkage.angle(), WithinAbs(1.2, 1e-6));
        CHECK(std::abs(linkage.speed(1)) < 1e-6);
    }
}

TEST_CASE("limits a full turn apart hold, from either side, and know how often the hinge has turned") {
    for (const auto& [low, high] : {std::pair{-pi, pi}, {0.0, 2.0 * pi}, {-1.5 * pi, 0.5 * pi}}) {
        for (const double speed : {2.0, -2.0, 20.0}) {
            Linkage linkage = pendulum(0.0);
            linkage.joints[0].hinge->motor = Motor{.speed = speed, .max_torque = 50.0};
            linkage.joints[0].hinge->limits = AngleLimits{low, high};
            linkage.build(whole, false);
            for (int i = 0; i < 600; ++i) linkage.step(1.0 / 60.0);
            INFO(low << " " << high << " at " << speed);
            CHECK_THAT(linkage.source->angles()[0], WithinAbs(speed > 0.0 ? high : low, 1e-4));
            CHECK(std::abs(linkage.speed(1)) < 1e-6);
        }
    }
}
