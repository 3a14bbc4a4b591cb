// What is predicted of free pairs, against closed forms and against fine samples.
#include "tests/fuzz/free_pair.h"

#include "engine/bodies/integrator.h"
#include "tests/catch.h"
#include "tests/fuzz/meetings.h"
#include "tests/random.h"

#include <cmath>

using namespace pushfactor;
using namespace pushfactor::tests;
using engine::Body;
using engine::Quaternion;
using engine::Vector3;

namespace {

constexpr double dt = 1.0 / 60.0;

Body flying(Body body, const Vector3& velocity, const Vector3& angular_momentum = Vector3::Zero()) {
    body.linear_momentum = velocity / body.inverse_mass;
    body.angular_momentum = angular_momentum;
    return body;
}

// The time at which boxes that do not turn begin to overlap along all 15 axes: along each one the gap falls or
// rises steadily. Infinity if there is none within `dt`.
double swept_boxes(const Vector3& size_a, const Body& a, const Vector3& size_b, const Body& b) {
    const engine::Matrix3 ra = a.orientation.toRotationMatrix(), rb = b.orientation.toRotationMatrix();
    std::vector<Vector3> axes;
    for (int i = 0; i < 3; ++i) {
        axes.emplace_back(ra.col(i));
        axes.emplace_back(rb.col(i));
        for (int k = 0; k < 3; ++k) axes.emplace_back(ra.col(i).cross(rb.col(k)).normalized());
    }
    double from = 0.0, until = dt;
    for (const Vector3& axis : axes) {
        double reach = 0.0;
        for (int i = 0; i < 3; ++i) {
            reach += 0.5 * (size_a[i] * std::abs(axis.dot(ra.col(i))) + size_b[i] * std::abs(axis.dot(rb.col(i))));
        }
        const double place = axis.dot(b.position - a.position), speed = axis.dot(velocity(b) - velocity(a));
        const double one = (-reach - place) / speed, other = (reach - place) / speed;
        from = std::max(from, std::min(one, other));
        until = std::min(until, std::max(one, other));
    }
    return from <= until ? from : engine::infinity;
}

Solid box_solid(const Vector3& size) {
    return solid_of({.name = "box", .shape = demos::BoxShape{size}});
}

}  // namespace

TEST_CASE("balls are predicted to touch when a quadratic equation says so") {
    Random random(1);
    int touching = 0;
    for (int i = 0; i < 2000; ++i) {
        const double ra = random.in(0.1, 0.5), rb = random.in(0.1, 0.5);
        const Solid one = solid_of({.name = "a", .shape = demos::SphereShape{ra}});
        const Solid other = solid_of({.name = "b", .shape = demos::SphereShape{rb}});
        const Vector3 place = random.vector(-1.0, 1.0), relative = random.vector(-80.0, 80.0);
        const double r = ra + rb;
        if (place.norm() < r + 0.01) continue;
        const FreeBody a{&one, flying(engine::ball_body(1.0, ra, Vector3::Zero()), Vector3::Zero(), {0.1, 0, 0})};
        const FreeBody b{&other, flying(engine::ball_body(2.0, rb, place), relative)};
        const double half = place.dot(relative), square = relative.squaredNorm();
        const double root = half * half - square * (place.squaredNorm() - r * r);
        const double time = root >= 0.0 ? (-half - std::sqrt(root)) / square : -1.0;
        const bool touches = time >= 0.0 && time <= dt;
        for (const Turning turning : {Turning::steady, Turning::torque_free}) {
            const auto found = PairStep(a, b, dt, turning).first_at(0.0);
            CHECK(found.has_value() == touches);
            // A distance of 1e-9 m is closed at the speed of approach, root / r.
            if (found && touches) CHECK(std::abs(*found - time) < 2e-9 * r / std::sqrt(root) + 1e-12);
        }
        if (!touches) continue;
        ++touching;
        const Prediction prediction = predict(a, b, dt, 1);
        REQUIRE(prediction.kind == Prediction::Kind::touches);
        if (prediction.normal) CHECK((*prediction.normal - (place + time * relative).normalized()).norm() < 1e-3);
    }
    CHECK(touching > 50);
}

TEST_CASE("boxes without spin are predicted to touch when the swept separating axes say so") {
    Random random(2);
    int touching = 0, passing = 0;
    for (int i = 0; i < 500; ++i) {
        const Vector3 size_a = random.vector(0.05, 1.0), size_b = random.vector(0.05, 1.0);
        const Solid one = box_solid(size_a), other = box_solid(size_b);
        const FreeBody a{&one, engine::box_body(1.0, size_a, Vector3::Zero(), random.rotation())};
        Body body = engine::box_body(2.0, size_b, random.vector(-1.0, 1.0), random.rotation());
        body = flying(body, random.vector(-80.0, 80.0));
        const FreeBody b{&other, body};
        const double time = swept_boxes(size_a, a.body, size_b, b.body);
        const auto found = PairStep(a, b, dt, Turning::steady).first_at(0.0);
        CHECK(found.has_value() == (time < engine::infinity));
        if (found && time < engine::infinity) CHECK(std::abs(*found - time) < 1e-7);  // 1.4e-9
        ++(found ? touching : passing);
    }
    CHECK(touching > 100);
    CHECK(passing > 100);
}

TEST_CASE("a rod that spins in place is predicted to hit a ball where a sine says so") {
    // Its long face, at half the thickness t from the axis, reaches a ball at distance d and of radius r when
    // d sin(angle) = r + t / 2.
    const Solid rod = box_solid({2.0, 0.1, 0.1});
    const Solid ball = solid_of({.name = "ball", .shape = demos::SphereShape{0.1}});
    Body spinning = engine::box_body(1.0, {2.0, 0.1, 0.1}, Vector3::Zero());
    const double rate = 20.0, d = 0.7;
    spinning.angular_momentum = Vector3(0, 0, rate / spinning.inverse_inertia.z());
    const double angle = std::asin(0.15 / d) + 0.1;  // of the ball at the start
    const Body resting = engine::ball_body(1.0, 0.1, d * Vector3(std::cos(angle), std::sin(angle), 0));
    for (const Turning turning : {Turning::steady, Turning::torque_free}) {
        const auto found = PairStep({&rod, spinning}, {&ball, resting}, dt, turning).first_at(0.0);
        REQUIRE(found);
        CHECK(std::abs(*found - 0.1 / rate) < 1e-9);
    }
    const Prediction touch = predict({&rod, spinning}, {&ball, resting}, dt, 10);
    CHECK(touch.kind == Prediction::Kind::touches);
    CHECK(touch.step == 1);
    REQUIRE(touch.normal);
    CHECK((*touch.normal - Vector3(-std::sin(0.1), std::cos(0.1), 0)).norm() < 1e-6);
}

TEST_CASE(
    "the free motions end a step at the pose of the integrator, and are one for a spin about a principal axis") {
    Random random(3);
    for (int i = 0; i < 50; ++i) {
        Body body = engine::box_body(1.0, random.vector(0.1, 1.0), Vector3::Zero(), random.rotation());
        body = flying(body, random.vector(-5, 5), random.vector(-1.0, 1.0));
        const Quaternion wanted = engine::rotate_by_small_turns(body, body.angular_momentum, dt);
        CHECK(moved(body, dt, dt, Turning::torque_free).orientation.angularDistance(wanted) < 1e-12);
        body.angular_momentum = body.orientation * Vector3(0, 0.3, 0);
        for (const double time : {0.2 * dt, dt}) {
            const Quaternion steady = moved(body, time, dt, Turning::steady).orientation;
            CHECK(moved(body, time, dt, Turning::torque_free).orientation.angularDistance(steady) < 1e-12);
        }
    }
}

TEST_CASE("fine samples of pairs that spin show no distance that a prediction excludes") {
    for (std::size_t kind = 0; kind < meeting_kinds().size(); ++kind) {
        for (const auto wanted : {Prediction::Kind::passes, Prediction::Kind::touches}) {
            const Meeting meeting = draw_meeting(wanted, kind, 1);
            auto [a, b] = bodies_of(meeting);
            const std::array<Solid, 2> solids{solid_of(meeting.scene.bodies[0]), solid_of(meeting.scene.bodies[1])};
            double least = engine::infinity;
            for (long step = 1; step <= meeting.steps; ++step) {
                for (int i = 0; i <= 500; ++i) {
                    for (const Turning turning : {Turning::steady, Turning::torque_free}) {
                        const Body here = moved(a, i * dt / 500, dt, turning),
                                   there = moved(b, i * dt / 500, dt, turning);
                        const double distance = closeness({solids[0], here.position, here.orientation},
                                                          {solids[1], there.position, there.orientation})
                                                    .distance;
                        least = std::min(least, distance);
                        if (step < meeting.steps || wanted == Prediction::Kind::passes) CHECK(distance > graze);
                    }
                }
                for (Body* body : {&a, &b}) *body = moved(*body, dt, dt, Turning::torque_free);
            }
            INFO(meeting.scene.name << ": " << least << " m");
            if (wanted == Prediction::Kind::touches) CHECK(least < graze);
            if (wanted == Prediction::Kind::passes) CHECK(least < 0.06 + 10.0 * meeting.speed * dt / 500);
        }
    }
}
