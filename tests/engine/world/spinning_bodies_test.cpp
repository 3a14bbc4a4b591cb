// Moved bodies that spin: rollers, drums and turntables, against closed forms.
#include "tests/catch.h"
#include "tests/engine/collision/hulls.h"
#include "tests/engine/world/moved_scene.h"
#include "tests/random.h"

#include <cmath>

using namespace pushfactor::engine;
using namespace pushfactor::tests;

namespace {

constexpr std::array rates{2.0, 5.0, 20.0, 60.0, 200.0};
constexpr std::array step_lengths{1.0 / 30.0, 1.0 / 60.0, 1.0 / 240.0};

Vector3 any_direction(Random& random) {
    return Vector3(random.in(-1, 1), random.in(-1, 1), random.in(-1, 1)).normalized();
}

// How far the last body gets from where it starts, in 3 s.
double largest_way(ContactScene& scene, double dt) {
    const Vector3 start = scene.world.bodies.back().position;
    double largest = 0.0;
    while (scene.world.time() < 3.0) {
        scene.world.step(dt);
        largest = std::max(largest, (scene.world.bodies.back().position - start).norm());
    }
    return largest;
}

// Four spheres of radius 0.3 at the corners of a square of 1.6 m or less, each spinning about an axis of its own.
void add_spinning_spheres(ContactScene& scene, double distance, double rate, Random& random) {
    for (const double x : {-0.5, 0.5}) {
        for (const double z : {-0.5, 0.5}) {
            scene.add(static_body({x * distance, 0, z * distance}), collision::Sphere{0.3}, {.friction = 0.0});
        }
    }
    for (int i = 0; i < 4; ++i) move(scene, i, {.angular_velocity = rate * any_direction(random)});
}

// A right prism about the y axis, 0.5 m high, with this many corners at radius 1.
collision::Polyhedron prism(int corners) {
    Points points;
    for (const double y : {-0.25, 0.25}) {
        for (int i = 0; i < corners; ++i) {
            const double angle = 2.0 * pi * i / corners;
            points.emplace_back(std::cos(angle), y, std::sin(angle));
        }
    }
    return polyhedron_of(points);
}

// A plank that starts 0.2 m beside the middle between spheres that turn towards each other below it.
struct Swing {
    double period = 0.0;  // s
    double least = 0.0;   // m, the smallest amplitude
};

Swing swing_on_rollers(double thickness, double mu, double rate, double dt) {
    const double distance = 1.6, radius = 0.3;
    ContactScene scene;
    // Three points of support: with four the normal forces are not determined, and the plank may turn.
    for (const Vector3& at : {Vector3(-1, 0, 0), Vector3(1, 0, -0.8), Vector3(1, 0, 0.8)}) {
        scene.add(static_body({0.5 * distance * at.x(), -radius, 0.5 * at.z()}), collision::Sphere{radius},
                  {.friction = mu});
    }
    scene.add_box({4, thickness, 1.2}, {0.2, 0.5 * thickness, 0}, {0, 0, 0}, {.friction = mu});
    for (int i = 0; i < 3; ++i) move(scene, i, {.angular_velocity = {0, 0, i < 1 ? -rate : rate}});
    scene.build();
    scene.world.kick_back_half(dt);
    double before = 0.2, first = -1.0, last = 0.0, largest = 0.0, least = 1.0;
    int crossings = 0;
    while (crossings < 5) {
        scene.world.step(dt);
        const double x = scene.world.bodies.back().position.x();
        largest = std::max(largest, std::abs(x));
        if (before * x < 0.0) {
            const double at = scene.world.time() - dt * x / (x - before);
            if (crossings > 0) least = std::min(least, largest);
            if (first < 0.0) first = at;
            last = at;
            ++crossings;
            largest = 0.0;
        }
        before = x;
        REQUIRE(scene.world.time() < 30.0);
    }
    return {.period = 2.0 * (last - first) / (crossings - 1), .least = least};
}

}  // namespace

TEST_CASE("spheres that spin without friction do nothing to a plank, or to a ball between them") {
    Random random(7);
    for (const double rate : rates) {
        for (const double dt : step_lengths) {
            INFO(rate << " rad/s, step " << dt);
            ContactScene plank;
            add_spinning_spheres(plank, 1.6, rate, random);
            plank.add_box({4, 0.1, 2}, {0.1, 0.35, 0.05}, {0, 0, 0}, {.friction = 0.0});
            plank.build();
            CHECK(largest_way(plank, dt) < 1e-6);

            ContactScene ball;
            add_spinning_spheres(ball, 0.8, rate, random);
            const double height = std::sqrt(0.7 * 0.7 - 0.4 * 0.4 - 0.4 * 0.4);
            ball.add_ball(0.4, {0, height, 0}, {0, 0, 0}, {.friction = 0.0});
            ball.build();
            CHECK(largest_way(ball, dt) < 1e-6);
        }
    }
}

// A face that turns about its normal stays where it is. About any other axis the surface of a box rises itself.
TEST_CASE(
    "boxes and polyhedra that spin about the normal of a face without friction do nothing to what lies on it") {
    for (const double rate : rates) {
        for (const double dt : step_lengths) {
            for (const int kind : {0, 1, 2}) {
                for (const bool ball : {false, true}) {
                    INFO(rate << " rad/s, step " << dt << ", kind " << kind << ", ball " << ball);
                    ContactScene scene;
                    if (kind == 0) {
                        scene.add_plate({2, 0.5, 2}, {0, -0.25, 0}, {.friction = 0.0});
                    } else {
                        scene.add(static_body({0, -0.25, 0}), prism(kind == 1 ? 5 : 24), {.friction = 0.0});
                    }
                    if (ball) {
                        scene.add_ball(0.3, {0.4, 0.3, 0.1}, {0, 0, 0}, {.friction = 0.0});
                    } else {
                        scene.add_box({4, 0.1, 0.6}, {0.1, 0.05, 0.1}, {0, 0, 0}, {.friction = 0.0});
                    }
                    move(scene, 0, {.angular_velocity = {0, rate, 0}});
                    scene.build();
                    CHECK(largest_way(scene, dt) < 1e-6);
                }
            }
        }
    }
}

TEST_CASE(
    "a plank on two rollers that turn towards each other swings with the period of mu g over half their distance") {
    for (const double thickness : {0.02, 0.1, 0.4}) {
        for (const double mu : {0.2, 0.5}) {
            for (const double rate : {10.0, 60.0, 200.0}) {
                const double dt = rate == 60.0 ? 1.0 / 60.0 : 1.0 / 240.0;
                const Swing swing = swing_on_rollers(thickness, mu, rate, dt);
                INFO("thickness " << thickness << ", mu " << mu << ", rate " << rate);
                const double expected = 2.0 * pi * std::sqrt((0.8 - 0.5 * mu * thickness) / (mu * g));
                CHECK(swing.period == Approx(expected).epsilon(5e-3));
                CHECK(swing.least == Approx(0.2).epsilon(0.01));
            }
        }
    }
}

// The wall is a box beside the axis of the drum, whose centre moves along chords too. So what goes along stays
// behind, by the square of the step.
TEST_CASE("a cube pressed against the inside of a drum that turns goes along, to the square of the step") {
    for (const double dt : step_lengths) {
        const double rate = 4.0, radius = 1.0;
        ContactScene scene;
        scene.add_plate({0.4, 4, 4}, {radius + 0.3, 0, 0}, {.friction = 1.0});
        Body& cube =
            scene.add_box(Vector3::Constant(0.2), {radius, 0, 0}, {0, 0, -rate * radius}, {.friction = 1.0});
        cube.angular_momentum = rate / cube.inverse_inertia.y() * Vector3::UnitY();
        std::vector<PlaceTable::Entry> entries;
        const int steps = static_cast<int>(std::lround(3.0 / dt));
        for (int i = 1; i <= steps; ++i) {
            const Quaternion turn = turned(rate * dt * i);
            entries.push_back({dt * i, {turn * Vector3(radius + 0.3, 0, 0), turn}});
        }
        scene.world.move(0, std::make_unique<PlaceTable>(place_of(scene.world.bodies[0]), entries));
        scene.build(Vector3::Zero());
        double deepest = 0.0;
        for (int i = 0; i < steps - 1; ++i) {
            scene.world.step(dt);
            deepest = std::max(deepest, scene.penetration());
        }
        INFO("step " << dt);
        const double square = std::pow(rate * dt, 2);
        CHECK(deepest < 0.01 * square * radius);
        const Vector3 at = turned(-rate * scene.world.time()) * scene.world.bodies[1].position;
        CHECK((at - Vector3(radius, 0, 0)).norm() < 10.0 * square * radius);
    }
}
