// Forces and torques on a body against their closed forms.
#include "engine/forces/poke.h"

#include "engine/energy_account.h"
#include "engine/world.h"
#include "tests/catch.h"

#include <cmath>

using namespace pushfactor::engine;
using Catch::Matchers::WithinAbs;

namespace {

constexpr double dt = 1.0 / 60.0;

// A body alone with one force on it.
World world_of(const Body& body, const Poke& poke) {
    World world;
    world.bodies = {body};
    world.forces.push_back(std::make_unique<PokeForce>(poke));
    return world;
}

}  // namespace

TEST_CASE("a torque spins a body up by torque time / moment about the axis, and moves it nowhere") {
    World world = world_of(box_body(3.0, {1, 2, 0.5}, {0, 0, 0}), {.body = 0, .torque = {0, 0, 0.7}});
    const double moment = 3.0 * (1.0 + 4.0) / 12.0;
    for (int i = 0; i < 120; ++i) world.step(dt);
    CHECK((angular_velocity(world.bodies[0]) - Vector3(0, 0, 0.7 * 2.0 / moment)).norm() < 1e-12);
    CHECK(world.bodies[0].position.norm() == 0.0);
    CHECK(world.bodies[0].linear_momentum.norm() == 0.0);
}

TEST_CASE("100 N for 10 ms are 1 N s, whatever the step and wherever in it they begin, also for a body at rest") {
    for (const double step : {1.0 / 10.0, 1.0 / 60.0, 1.0 / 240.0, 1.0 / 1000.0}) {
        for (const double from : {0.0, 0.505, 0.5, 0.4931}) {
            for (const bool rests : {false, true}) {
                World world = world_of(ball_body(1.0, 0.5, {0, 0, 0}),
                                       {.body = 0, .force = {100, 0, 0}, .from = from, .until = from + 0.01});
                if (rests) world.rest = std::make_unique<Rest>();
                while (world.time() < 0.6) world.step(step);
                INFO("step " << step << " from " << from << (rests ? ", at rest" : ""));
                CHECK(std::abs(world.bodies[0].linear_momentum.x() - 1.0) < 1e-7);
            }
        }
    }
}

TEST_CASE("a force at a point of a body pushes like one at its centre and turns by lever x force") {
    World world = world_of(ball_body(2.0, 0.5, {1, 2, 3}),
                           {.body = 0, .force = {0, 4, 0}, .point = {0.3, 0, 0.1}, .from = 0.0, .until = dt});
    world.step(dt);
    const Vector3 lever(0.3, 0, 0.1), force(0, 4, 0);
    CHECK((world.bodies[0].linear_momentum - dt * force).norm() < 1e-15);
    CHECK((world.bodies[0].angular_momentum - dt * lever.cross(force)).norm() < 1e-15);
    world.step(dt);  // it has ended
    CHECK((world.bodies[0].linear_momentum - dt * force).norm() < 1e-15);
}

TEST_CASE("a force in the frame of a body turns with it: spinning at omega its momentum is the arc of a circle") {
    // p' = F (cos omega t, 0, -sin omega t) about y, so p(t) = F / omega (sin omega t, 0, cos omega t - 1).
    const double omega = 2.0, force = 3.0, time = 1.3;
    Body body = ball_body(1.0, 0.5, {0, 0, 0});
    body.angular_momentum = {0, omega / body.inverse_inertia.y(), 0};
    double error = 1.0;
    for (const int steps : {400, 800}) {
        World world = world_of(body, {.body = 0, .force = {force, 0, 0}, .frame = Poke::Frame::body});
        for (int i = 0; i < steps; ++i) world.step(time / steps);
        const Vector3 exact = force / omega * Vector3(std::sin(omega * time), 0, std::cos(omega * time) - 1.0);
        const double now = (world.bodies[0].linear_momentum - exact).norm();
        CHECK(now < 0.6 * error);
        error = now;
    }
    CHECK(error < 0.01);
}

TEST_CASE("a torque in the frame of a body goes on about the body's own axis") {
    Body body = box_body(1.0, {1, 1, 1}, {0, 0, 0});
    body.orientation = Quaternion(Eigen::AngleAxisd(0.5, Vector3::UnitX()));
    World world = world_of(body, {.body = 0, .torque = {0, 0, 0.2}, .frame = Poke::Frame::body});
    for (int i = 0; i < 60; ++i) world.step(dt);
    const Vector3 axis = body.orientation * Vector3::UnitZ();
    CHECK((angular_velocity(world.bodies[0]) - 0.2 / (1.0 / 6.0) * axis).norm() < 1e-9);
}

TEST_CASE("what a torque and a force at a point do is work from outside, not energy gained") {
    for (const Poke::Frame frame : {Poke::Frame::world, Poke::Frame::body}) {
        World world =
            world_of(box_body(1.0, {1, 0.6, 0.4}, {0, 0, 0}),
                     {.body = 0, .force = {0, 4, 0}, .torque = {0, 0.5, 0}, .point = {0.5, 0, 0}, .frame = frame});
        EnergyAccount account{Vector3::Zero()};
        account.open(world.bodies, 1e-3);
        for (int i = 0; i < 1000; ++i) {
            account.begin(world.bodies);
            world.step(1e-3);
            account.end(world, 1e-3);
        }
        CHECK(account.external_work() > 5.0);
        CHECK_THAT(account.gain(), WithinAbs(0.0, 0.01 * account.external_work()));
    }
}

TEST_CASE("only a force at the centre and in the world's frame leaves it unseen that a ball turns") {
    CHECK(PokeForce({.body = 1, .force = {0, 1, 0}, .torque = {0, 1, 0}}).turns_unseen(1));
    CHECK(!PokeForce({.body = 1, .force = {0, 1, 0}, .point = {0.1, 0, 0}}).turns_unseen(1));
    CHECK(!PokeForce({.body = 1, .force = {0, 1, 0}, .frame = Poke::Frame::body}).turns_unseen(1));
    CHECK(PokeForce({.body = 1, .force = {0, 1, 0}, .frame = Poke::Frame::body}).turns_unseen(0));
}
