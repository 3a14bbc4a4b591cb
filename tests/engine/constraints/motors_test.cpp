// Motors of hinges, and brakes, against closed forms.
#include "tests/catch.h"
#include "tests/engine/constraints/linkage.h"

using namespace pushfactor::engine;
using namespace pushfactor::tests;
using Catch::Matchers::WithinAbs;

TEST_CASE("a motor that is too weak to lift its bar stalls where gravity's torque is its own") {
    const double torque = 3.0, stall = std::asin(torque / (bar_mass * 10.0 * arm));
    Linkage linkage = pendulum(0.0);
    linkage.joints[0].hinge->motor = Motor{.speed = 0.02, .max_torque = torque};
    linkage.build();
    const double swing = 0.02 / std::sqrt(bar_mass * 10.0 * arm * std::cos(stall) / bar_moment);
    for (int i = 1; i <= 60 * 60; ++i) {
        linkage.step(1.0 / 60.0);
        // On its way it has its speed.
        if (i > 60 && i < 60 * 25) REQUIRE_THAT(linkage.speed(1), WithinAbs(0.02, 1e-9));
        if (i > 60 * 40) REQUIRE(std::abs(linkage.angle() - stall) < 1.5 * swing);
    }
    CHECK(linkage.angle() > stall - 1.5 * swing);
}

TEST_CASE("a motor that is strong enough keeps its speed over the top, and its work is the height") {
    Linkage linkage = pendulum(0.0);
    linkage.joints[0].hinge->motor = Motor{.speed = 0.5, .max_torque = 6.0};
    linkage.build();
    const double dt = 1.0 / 240.0;
    linkage.account.open(linkage.world.bodies, dt);
    double seconds = 0.0;
    for (int i = 0; linkage.angle() >= 0.0; ++i) {
        linkage.step(dt);
        seconds += dt;
        if (i >= 10) REQUIRE_THAT(linkage.speed(1), WithinAbs(0.5, 1e-9));  // it starts up in 0.03 s
    }
    CHECK_THAT(seconds, WithinAbs(2.0 * pi, 0.03));  // half a turn
    const double motion = 0.5 * bar_moment * 0.25;
    CHECK_THAT(linkage.account.external_work(), WithinAbs(10.0 + motion, 0.01));
    CHECK_THAT(linkage.account.gain(), WithinAbs(0.0, 0.01));
}

TEST_CASE("a flywheel starts up in moment x speed / torque, and runs on at its speed") {
    const double torque = 2.0, speed = 30.0;
    Linkage linkage;
    const int wheel = linkage.add(ball_body(5.0, 0.4, {0, 0, 0}));
    linkage.join(0, wheel, Vector3::Zero()).hinge->motor = Motor{.speed = speed, .max_torque = torque};
    linkage.build(whole, false);
    const double moment = 0.4 * 5.0 * 0.16, exact = moment * speed / torque, dt = exact / 2000.5;
    linkage.account.open(linkage.world.bodies, dt);
    int steps = 0;
    for (; linkage.speed(1) < speed * (1.0 - 1e-9); ++steps) linkage.step(dt);
    CHECK(std::abs(steps * dt / exact - 1.0) < 1e-3);
    for (int i = 0; i < 100; ++i) linkage.step(dt);
    CHECK_THAT(linkage.speed(1), WithinAbs(speed, 1e-9));
    CHECK_THAT(linkage.account.external_work(), WithinAbs(0.5 * moment * speed * speed, 1e-6));
    CHECK_THAT(linkage.account.gain(), WithinAbs(0.0, 1e-6));
}

TEST_CASE("a brake, a motor of speed zero, stops what its torque can stop, and is no work from outside") {
    Linkage linkage;
    const int wheel = linkage.add(ball_body(5.0, 0.4, {0, 0, 0}));
    linkage.join(0, wheel, Vector3::Zero()).hinge->motor = Motor{.speed = 0.0, .max_torque = 1.0};
    const double moment = 0.4 * 5.0 * 0.16;
    linkage.world.bodies[1].angular_momentum = {0, 0, 2.0};
    linkage.build(whole, false);
    linkage.account.open(linkage.world.bodies, 0.01);
    for (int i = 0; i < 199; ++i) linkage.step(0.01);
    CHECK_THAT(linkage.speed(1), WithinAbs(0.01 / moment, 1e-9));
    for (int i = 0; i < 10; ++i) linkage.step(0.01);
    CHECK_THAT(linkage.speed(1), WithinAbs(0.0, 1e-9));
    CHECK(linkage.account.external_work() == 0.0);
    CHECK(linkage.account.gain() < 0.0);
}

TEST_CASE("a motor between two free bodies turns them against each other and gives them no momentum") {
    Linkage linkage;
    const int a = linkage.add(box_body(1.0, {1, 0.4, 0.3}, {-0.5, 0, 0}));
    const int b = linkage.add(box_body(3.0, {1, 0.8, 0.3}, {0.5, 0, 0}));
    linkage.join(a, b, Vector3::Zero()).hinge->motor = Motor{.speed = 2.0, .max_torque = 4.0};
    linkage.build(whole, false);
    linkage.account.open(linkage.world.bodies, 1e-3);
    for (int i = 0; i < 2000; ++i) linkage.step(1e-3);
    CHECK_THAT(linkage.speed(2) - linkage.speed(1), WithinAbs(2.0, 1e-9));
    CHECK(linear_momentum(linkage.world.bodies).norm() < 1e-12);
    CHECK(angular_momentum(linkage.world.bodies).norm() < 1e-12);
    CHECK(std::abs(linkage.account.gain()) < 0.01 * linkage.account.external_work());
}

TEST_CASE("a servo turns to its angle, also whole turns away, and gives way to a load by torque / stiffness") {
    for (const double target : {0.7, -2.0, 9.0}) {
        Linkage linkage = pendulum(0.0);
        linkage.joints[0].hinge->motor =
            Motor{.servo = Servo{.angle = target, .stiffness = 400.0, .damping = 60.0}};
        linkage.build(whole, true);
        for (int i = 0; i < 900; ++i) linkage.step(1.0 / 60.0);
        const double angle = linkage.source->angles()[0];
        const Body& turned = linkage.world.bodies[1];
        const double load = -gravity.cross(turned.mass() * turned.position).z();
        CHECK_THAT(angle, WithinAbs(target + load / 400.0, 1e-4));
        CHECK(std::abs(linkage.speed(1)) < 1e-6);
    }
}

TEST_CASE("a servo without damping swings with the energy that its spring stores") {
    Linkage linkage = pendulum(0.0);
    linkage.joints[0].hinge->motor = Motor{.servo = Servo{.angle = 0.5, .stiffness = 20.0}};
    linkage.build(whole, false);
    const double moment = 0.5 * 20.0 * 0.25;  // J, wound up
    CHECK_THAT(linkage.source->stored_energy(linkage.world.bodies), WithinAbs(moment, 1e-12));
    double most = 0.0;
    for (int i = 0; i < 4000; ++i) {
        linkage.step(1.0 / 4000.0);
        most = std::max(most, kinetic_energy(linkage.world.bodies));
        CHECK(kinetic_energy(linkage.world.bodies) + linkage.source->stored_energy(linkage.world.bodies) <
              moment * (1.0 + 1e-9));
    }
    CHECK(most > 0.95 * moment);
}
