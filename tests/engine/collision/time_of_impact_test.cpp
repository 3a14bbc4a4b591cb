#include "engine/collision/time_of_impact.h"

#include "engine/collision/pairs/collide.h"
#include "tests/catch.h"
#include "tests/engine/collision/pose.h"
#include "tests/random.h"

#include <cmath>

using namespace pushfactor::engine;
using namespace pushfactor::engine::collision;
using pushfactor::tests::at;
using pushfactor::tests::Random;

namespace {

constexpr double dt = 1.0 / 60.0;

// The first of many sampled times at which the shapes overlap; `dt` if there is none.
double first_overlap(const Moving& a, const Moving& b, int moments) {
    for (int i = 0; i < moments; ++i) {
        const double time = dt * i / moments;
        Manifold manifold;
        collide(a.shape, pose_at(a, time), b.shape, pose_at(b, time), 0.0, manifold);
        if (manifold.count > 0) return time;
    }
    return dt;
}

Shape random_shape(Random& random) {
    const Vector3 half = random.vector(0.05, 0.6);
    if (random.in(0, 1) < 0.3) return Sphere{half.x()};
    return Box{half};
}

Moving random_moving(Random& random, const Shape& shape, double speed, double turning) {
    const Vector3 position = random.vector(-1.2, 1.2);
    const Quaternion rotation = random.rotation();
    const Vector3 velocity = random.vector(-speed, speed);
    return {shape, at(position, rotation), {velocity, random.vector(-turning, turning)}};
}

}  // namespace

TEST_CASE("the moment in which two spheres meet is the root of a quadratic") {
    const Shape ball = Sphere{0.5};
    const Moving a{ball, at({0, 0, 0}), {{0, 0, 0}, Vector3::Zero()}};
    const Moving b{ball, at({3, 0.6, 0}), {{-200, 0, 0}, Vector3::Zero()}};
    CHECK(course_of(a, b, dt, 1e-12).time == Approx(2.2 / 200.0).epsilon(1e-10));  // 0.8 apart in x and 0.6 in y
}

TEST_CASE("a box that falls flat meets the ground and another box with its whole face") {
    const Shape box = Box{Vector3::Constant(0.5)};
    const Shape ground = Plane{};
    const Moving falling{box, at({0.2, 2.5, 0}), {{0, -200, 0}, Vector3::Zero()}};
    for (const Moving& below : {Moving{ground, at({0, 0, 0}), {}}, Moving{box, at({0, -0.5, 0}), {}}}) {
        const double time = course_of(below, falling, dt, 1e-7).time;
        CHECK(time == Approx(0.01).margin(1e-9));
        Manifold manifold;
        collide(below.shape, pose_at(below, time), box, pose_at(falling, time), 1e-4, manifold);
        CHECK(manifold.normal.y() == Approx(1.0));
        CHECK(manifold.count == 4);
    }
}

TEST_CASE("the tip of a rod that turns about its middle meets a wall when its angle says so") {
    const Shape rod = Box{{1.0, 1e-6, 0.05}};
    const Shape wall = Plane{};
    const double rate = 70.0;
    const Moving turning{rod, at({0, 0.6, 0}), {{0, 0, 0}, {0, 0, rate}}};
    CHECK(course_of({wall, at({0, 0, 0}), {}}, turning, dt, 1e-7).time ==
          Approx(std::asin(0.6) / rate).epsilon(1e-5));
    const Moving slower{rod, at({0, 0.6, 0}), {{0, 0, 0}, {0, 0, 0.9 * std::asin(0.6) / dt}}};
    CHECK(course_of({wall, at({0, 0, 0}), {}}, slower, dt, 1e-7).time == never);
}

TEST_CASE("random shapes meet when a search in small steps says so, and only then") {
    Random random(31);
    int meetings = 0;
    int passes = 0;
    for (int i = 0; i < 600; ++i) {
        const Shape shape_a = random_shape(random);
        const Shape shape_b = random_shape(random);
        const Moving a = random_moving(random, shape_a, 150, i % 2 ? 60 : 0);
        const Moving b = random_moving(random, shape_b, 150, i % 4 > 1 ? 60 : 0);
        const int moments = 1000;
        const double found_by_search = first_overlap(a, b, moments);
        if (found_by_search == 0.0) continue;  // no meeting, but an overlap at the start
        const Course course = course_of(a, b, dt, 1e-7);
        INFO("case " << i << ", found in steps " << found_by_search << ", found " << course.time);
        CHECK(course.decided);
        if (found_by_search < dt) {
            ++meetings;
            // Only a graze shorter than one small step may be missed: none is.
            CHECK(course.time <= found_by_search + 1e-9);
            CHECK(course.time > found_by_search - 1.1 * dt / moments);
        } else if (course.time == never) {
            ++passes;
        }
    }
    CHECK(meetings > 30);
    CHECK(passes > 300);
}

TEST_CASE("the sum of what the motion may close bounds what it closes") {
    Random random(5);
    const Shape shape = Box{{0.8, 0.1, 0.3}};
    const Shape wall = Plane{};
    for (int i = 0; i < 200; ++i) {
        const Moving moving = random_moving(random, shape, 20, 40);
        const Moving ground{wall, at({0, -3, 0}), {}};
        const double time = random.in(0.001, dt);
        const auto lowest = [&](double t) {
            const Pose pose = pose_at(moving, t);
            return pose.position.y() - pose.rotation.row(1).cwiseAbs().dot(Vector3(0.8, 0.1, 0.3));
        };
        CHECK(lowest(0.0) - lowest(time) <= approach(ground, moving, Vector3::UnitY(), time) + 1e-12);
    }
}
