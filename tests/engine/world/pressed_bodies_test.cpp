// Bodies that a force or a torque moves by more than their size within one step: no tunnelling, resting bodies are
// not swept, and an undecided sweep keeps its contact.
#include "engine/collision/time_of_impact.h"
#include "engine/forces/poke.h"
#include "tests/catch.h"
#include "tests/engine/contact_scene.h"
#include "tests/random.h"

#include <cmath>

using namespace pushfactor::engine;
using pushfactor::tests::ContactScene;
using pushfactor::tests::Random;

namespace {

// Pushes one body, from the start.
class Press : public ForceSource {
  public:
    Press(int body, const Vector3& force, const Vector3& torque, double until)
        : body_(static_cast<std::size_t>(body)), force_(force), torque_(torque), until_(until) {}

    void add_forces(const ForcedBodies& bodies, double time, double) override {
        if (time >= until_) return;
        bodies[body_].force += force_;
        bodies[body_].torque += torque_;
    }

  private:
    std::size_t body_;
    Vector3 force_, torque_;
    double until_;
};

void press_last(ContactScene& scene, const Vector3& force, double until = 0.1,
                const Vector3& torque = Vector3::Zero()) {
    const int last = static_cast<int>(scene.world.bodies.size()) - 1;
    scene.world.forces.push_back(std::make_unique<Press>(last, force, torque, until));
}

}  // namespace

TEST_CASE("a ball that a force presses onto a thin plate from any height stays above it") {
    for (const double force : {3e2, 3e3, 2.7e4, 1e6}) {
        for (const double height : {0.0, 1e-3, 0.003, 0.02, 0.3, 1.0}) {
            ContactScene scene;
            scene.add_plate({10, 0.05, 10}, {0, -0.025, 0});
            scene.add_ball(0.1, {0, 0.1 + height, 0});
            scene.build();
            press_last(scene, {0, -force, 0});
            const auto seen = scene.watch(60);
            INFO(force << " N from " << height << " m");
            CHECK(seen.lowest > 0.1 - 1e-3);
            CHECK(scene.world.bodies.back().position.y() == Approx(0.1).margin(1e-3));
            CHECK(seen.speed_at_end < 1e-6);
        }
    }
}

TEST_CASE("boxes that a force presses at a wall, or at each other, do not get through") {
    for (const double force : {1e3, 3e4, 1e6}) {
        for (const Vector3& size : {Vector3(0.2, 0.2, 0.2), Vector3(0.02, 0.5, 0.5), Vector3(1.0, 0.1, 0.1)}) {
            ContactScene scene;
            scene.add_plate({0.05, 4, 4}, {2.0, 0, 0});
            scene.add_box(size, {1.0, 0, 0});
            scene.add_box(size, {-0.3, 0, 0});
            scene.build(Vector3::Zero());
            press_last(scene, {force, 0, 0});
            scene.watch(60);
            INFO(force << " N on " << size.transpose());
            const double wall = 2.0 - 0.025;
            CHECK(scene.world.bodies[1].position.x() < wall - 0.49 * size.x());
            CHECK(scene.world.bodies[2].position.x() < scene.world.bodies[1].position.x() - 0.98 * size.x());
        }
    }
}

TEST_CASE("a plate that is pulled up under a resting ball carries it, and does not pass it") {
    for (const double force : {1e3, 1e5}) {
        for (const double height : {0.0, 0.05, 0.2}) {
            ContactScene scene;
            scene.add_ball(0.1, {0, 0.1 + height, 0});
            scene.add_box({2, 0.05, 2}, {0, -0.025, 0});
            scene.build(Vector3::Zero());
            press_last(scene, {0, force, 0});
            scene.watch(30);
            const auto& bodies = scene.world.bodies;
            CHECK(bodies[0].position.y() - bodies[1].position.y() > 0.125 - 1e-3);
        }
    }
}

TEST_CASE("a rod that a torque turns at a thin wall does not get through it") {
    for (const double torque : {1e2, 5e2, 1e3}) {
        ContactScene scene;
        scene.add_plate({0.5, 0.05, 4}, {0.7, -0.4, 0}, {.friction = 0.0});
        scene.add_box({2, 0.1, 0.1}, Vector3::Zero(), Vector3::Zero(), {.friction = 0.0});
        scene.build(Vector3::Zero());
        press_last(scene, Vector3::Zero(), 1.0 / 60.0, {0, 0, -torque});
        scene.watch(1);
        const Body& rod = scene.world.bodies.back();
        INFO(torque << " N m");
        const double angle = 2.0 * std::atan2(rod.orientation.z(), rod.orientation.w());
        CHECK(angle < 0.0);
        CHECK(angle > -0.7);  // it touches the plate at about 0.5
        CHECK(scene.penetration() < 0.02);
    }
}

TEST_CASE("what rests under its weight touches at the start of the step, however small") {
    // Smaller ones fall farther than their size in a step, past what they lie on.
    for (const double size : {1.0, 0.1, 0.01}) {
        ContactScene scene;
        scene.add_ground();
        for (int i = 0; i < 3; ++i) scene.add_box(Vector3::Constant(size), {0, (0.5 + i) * size, 0});
        scene.add_ball(0.5 * size, {0, 3.5 * size, 0});
        scene.build();
        scene.watch(30);
        for (Body& body : scene.world.bodies) {
            if (!body.is_static()) body.force = {0, -10 * body.mass(), 0};
        }
        const auto& touches = scene.touches();
        REQUIRE(touches.size() >= 4);
        INFO("size " << size);
        for (const collision::Touch& touch : touches) CHECK(touch.time == 0.0);
    }
}

TEST_CASE("a body that lies on something is held by it, however it is pressed") {
    for (const double force : {1e2, 1e4, 1e6}) {
        ContactScene scene;
        scene.add_plate({10, 0.02, 10}, {0, -0.01, 0});
        scene.add_box({0.3, 0.02, 0.3}, {0, 0.01, 0});
        scene.build();
        scene.watch(20);
        press_last(scene, {0, -force, 0}, 10.0);
        const auto seen = scene.watch(60);
        CHECK(seen.lowest > 0.01 - 1e-4);
    }
}

TEST_CASE("a slightly tilted box that spins at up to 1000 rad/s settles on its plate and not in it") {
    for (const double rate : {100.0, 300.0, 1000.0, 3000.0}) {
        for (const double tilt : {1e-4, 1e-3, 0.01, 0.05}) {
            ContactScene scene;
            scene.add_plate({20, 0.2, 20}, {0, -0.1, 0});
            Body& box = scene.add_box({0.4, 0.2, 0.4}, {0, 0.1 + 0.25 * tilt, 0});
            box.orientation = Quaternion(Eigen::AngleAxisd(tilt, Vector3(1, 0, 0.4).normalized()));
            box.angular_momentum = world_inverse_inertia(box).inverse() * Vector3(0, rate, 0);
            scene.build();
            const auto seen = scene.watch(240);
            INFO(rate << " rad/s tilted by " << tilt << ": lowest " << seen.lowest << " fastest up "
                      << seen.upward_speed << " deepest " << seen.penetration);
            CHECK(seen.lowest > 0.1 - 0.01);
        }
    }
}

TEST_CASE("what the sweep cannot decide about in so many waits keeps the touch that was there") {
    ContactScene scene;
    scene.add_plate({20, 0.2, 20}, {0, -0.1, 0});
    Body& box = scene.add_box({0.4, 0.2, 0.4}, {0, 0.1 + 0.00165, 0});
    box.orientation = Quaternion(Eigen::AngleAxisd(1e-3, Vector3::UnitX()));
    box.angular_momentum = world_inverse_inertia(box).inverse() * Vector3(3e2, 3e5, 0);
    const auto& bodies = scene.world.bodies;
    const auto moving = [&](std::size_t i) {
        return collision::Moving{scene.colliders[i].shape, collision::pose_of(bodies[i]), motion_of(bodies[i])};
    };
    const collision::Course course = course_of(moving(0), moving(1), ContactScene::dt, 4e-8);
    CHECK(course.time == never);
    CHECK(!course.decided);
    CHECK(scene.touches().size() == 1);
}
