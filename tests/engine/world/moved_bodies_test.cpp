// Static bodies that are moved: what stands on them, meets them or hangs on them, against closed forms.
#include "engine/constraints/distance_constraints.h"
#include "engine/energy_account.h"
#include "tests/catch.h"
#include "tests/engine/world/moved_scene.h"

#include <cmath>

using namespace pushfactor::engine;
using namespace pushfactor::tests;

namespace {

// The largest gap between a cube and the shaker that it stands on, which begins at its lowest point.
double largest_gap(Under what, double peak_acceleration, double dt) {
    const double frequency = 2.0, omega = 2.0 * pi * frequency;
    ContactScene scene;
    add_under(scene, what);
    if (what == Under::ball) {
        scene.add_ball(0.5, {0, 0.5, 0});
    } else {
        scene.add_box(Vector3::Ones(), {0, 0.5, 0});
    }
    shake(scene, 0, {0, peak_acceleration / (omega * omega), 0}, frequency, -0.5 * pi);
    scene.build();
    const double start = scene.world.bodies[1].position.y() - scene.world.bodies[0].position.y();
    double largest = 0.0;
    while (scene.world.time() < 1.0) {
        scene.world.step(dt);
        const double now = scene.world.bodies[1].position.y() - scene.world.bodies[0].position.y();
        largest = std::max(largest, now - start);
    }
    return largest;
}

struct OnTable {
    double slipped = 0.0;  // m, across the table
    double radius = 0.0;   // m, at the end
};

// A ball-less cube of 0.2 m at `radius` on a table that turns with `rate`, 2 s long.
OnTable on_turntable(double rate, double mu, double radius, double dt) {
    ContactScene scene;
    scene.add_plate({8, 1, 8}, {0, -0.5, 0}, {.friction = mu});
    Body& cube = scene.add_box(Vector3::Constant(0.2), {radius, 0.1, 0}, {0, 0, -rate * radius}, {.friction = mu});
    cube.angular_momentum = rate / cube.inverse_inertia.y() * Vector3::UnitY();
    move(scene, 0, {.angular_velocity = {0, rate, 0}});
    scene.build();
    const int steps = static_cast<int>(std::lround(2.0 / dt));
    for (int i = 0; i < steps; ++i) scene.world.step(dt);
    const Vector3 expected = turned(rate * 2.0) * Vector3(radius, 0.1, 0);
    const Vector3 at = scene.world.bodies[1].position;
    return {(at - expected).norm(), std::hypot(at.x(), at.z())};
}

}  // namespace

TEST_CASE("what stands on a shaker keeps in touch while its acceleration stays below g, and lifts off above") {
    const double dt = 1.0 / 480.0;
    for (const Under what : all_under) {
        INFO("kind " << static_cast<int>(what));
        double low = 0.9 * g, high = 1.1 * g;
        REQUIRE(largest_gap(what, low, dt) < 1e-7);
        REQUIRE(largest_gap(what, high, dt) > 1e-3);
        for (int i = 0; i < 9; ++i) {
            const double middle = 0.5 * (low + high);
            (largest_gap(what, middle, dt) < 1e-7 ? low : high) = middle;
        }
        // Over a step the mean acceleration is smaller by the square of sin(x) / x, x = pi f dt: 6e-5.
        CHECK(high == Approx(g).epsilon(1e-3));
    }
}

TEST_CASE("a stack on a shaker stands on it as on the ground") {
    // At most 3.9 m/s^2, below mu g and what would tip it. In small steps it would slide by 4e-4 m and more.
    for (const Vector3& along : {Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0.7, 0.7, 0)}) {
        for (int count = 1; count <= 4; ++count) {
            ContactScene scene;
            add_under(scene, Under::plate, {.friction = 0.6});
            for (int i = 0; i < count; ++i) {
                scene.add_box({0.4, 0.2, 0.4}, {0, 0.1 + 0.2 * i, 0}, Vector3::Zero(), {.friction = 0.6});
            }
            shake(scene, 0, 0.1 * along, 1.0, -0.5 * pi);
            scene.build();
            scene.world.small_steps = std::make_unique<SmallSteps>();
            const std::vector<Body> start = scene.world.bodies;
            double largest = 0.0;
            for (int i = 0; i < 120; ++i) {
                scene.world.step(ContactScene::dt);
                const Vector3 moved = scene.world.bodies[0].position - start[0].position;
                for (std::size_t k = 1; k < start.size(); ++k) {
                    const Vector3 own = scene.world.bodies[k].position - start[k].position;
                    largest = std::max(largest, (own - moved).norm());
                }
            }
            INFO(count << " along " << along.transpose());
            CHECK(largest < 1e-9);
        }
    }
}

TEST_CASE("a turntable keeps a cube inside the radius mu g / omega^2 where it is, and throws one outside off") {
    const double mu = 0.3, rate = 2.0, limit = mu * g / (rate * rate);
    for (const double dt : {1.0 / 60.0, 1.0 / 240.0}) {
        const OnTable inside = on_turntable(rate, mu, 0.998 * limit, dt);
        CHECK(inside.slipped < 2e-5);  // it begins along the tangent, not along the chord of the first step
        const OnTable outside = on_turntable(rate, mu, 1.002 * limit, dt);
        CHECK(outside.slipped > 1e-3);
        CHECK(outside.radius > 1.003 * limit);
    }
}

TEST_CASE("a ball that rolls on a turntable goes in a circle, at 2/7 of its rate") {
    const double rate = 3.0, dt = 1.0 / 240.0, circling = 2.0 / 7.0 * rate;
    ContactScene scene;
    scene.add_plate({20, 1, 20}, {0, -0.5, 0}, {.friction = 1.0});
    // In the frame of the room it circles about the middle if it begins with the speed of that circle.
    Body& ball = scene.add_ball(0.25, {1, 0.25, 0}, {0, 0, -circling}, {.friction = 1.0});
    // Rolling: v + w x (0, -r, 0) = rate x p, with the table's speed of (0, 0, -rate) here.
    ball.angular_momentum = Vector3((-rate + circling) / -0.25, 0, 0) / ball.inverse_inertia.x();
    move(scene, 0, {.angular_velocity = {0, rate, 0}});
    scene.build();
    const double period = 2.0 * pi / circling;
    const int steps = static_cast<int>(std::lround(period / dt));
    double farthest = 0.0, nearest = 1e9;
    for (int i = 0; i < steps; ++i) {
        scene.world.step(dt);
        const double radius = std::hypot(scene.world.bodies[1].position.x(), scene.world.bodies[1].position.z());
        farthest = std::max(farthest, radius);
        nearest = std::min(nearest, radius);
    }
    CHECK(farthest < 1.0001);
    CHECK(nearest > 0.9999);
    CHECK((scene.world.bodies[1].position - Vector3(1, 0.25, 0)).norm() < 0.002);
}

TEST_CASE("a piston gives a cube its speed, and the energy account knows all of its work") {
    const double speed = 1.5, dt = 1.0 / 60.0;
    for (const Under what : {Under::plate, Under::plane}) {
        ContactScene scene;
        add_under(scene, what);
        scene.add_box(Vector3::Ones(), {0, 0.5, 0});
        move(scene, 0, {.velocity = {0, speed, 0}}, {.from = 0.5, .until = 1.5});
        scene.build();
        EnergyAccount account({0, -g, 0});
        account.open(scene.world.bodies, dt);
        double least = 0.0, most = 0.0;
        for (int i = 0; i < 120; ++i) {
            account.begin(scene.world.bodies);
            scene.world.step(dt);
            account.end(scene.world, dt);
            const double time = scene.world.time();
            if (time > 0.51 && time < 1.49) {
                CHECK(velocity(scene.world.bodies[1]).y() == Approx(speed).epsilon(1e-9));
                least = std::min(least, account.gain());
                most = std::max(most, account.gain());
            }
        }
        // While it goes up nothing is gained or lost; when it stops the cube flies on, and falls back on it.
        // Momenta are half a step early.
        CHECK(most < 1e-6);
        CHECK(least > -1e-6);
        const double of_speed = 0.5 * speed * speed, early = 0.5 * dt * g * speed;
        CHECK(account.external_work() == Approx(g * speed + of_speed - early).epsilon(1e-6));
        CHECK(account.gain() == Approx(early - of_speed).epsilon(1e-4));
        CHECK(scene.world.bodies[1].position.y() == Approx(0.5 + speed).epsilon(1e-4));
    }
}

TEST_CASE("a ball bounces off a moving plate with epsilon times the speed in the frame of the plate") {
    const double epsilon = 0.7, dt = 1.0 / 240.0;
    for (const Under what : all_under) {
        for (const double plate : {-1.0, 0.0, 2.0, 20.0}) {
            for (const double ball : {-3.0, 0.0}) {
                if (plate <= ball) continue;
                ContactScene scene;
                add_under(scene, what, {.friction = 0.0, .restitution = epsilon});
                scene.add_ball(0.1, {0, 0.4, 0}, {0, ball, 0}, {.friction = 0.0});
                move(scene, 0, {.velocity = {0, plate, 0}});
                scene.build(Vector3::Zero());
                for (int i = 0; i < 200; ++i) scene.world.step(dt);
                INFO("kind " << static_cast<int>(what) << ", plate " << plate << ", ball " << ball);
                CHECK(velocity(scene.world.bodies[1]).y() ==
                      Approx(plate + epsilon * (plate - ball)).epsilon(1e-9));
            }
        }
    }
}

TEST_CASE("nothing tunnels through a fast moved body, and a body at rest does not either") {
    for (const double speed : {1.0, 10.0, 100.0, 1000.0}) {
        for (const bool rests : {false, true}) {
            ContactScene scene;
            scene.add_plate({0.1, 2, 2}, {-5.0, 1.0, 0});
            scene.add_ground();
            scene.add_box(Vector3::Constant(0.2), {0, 0.1, 0});
            move(scene, 0, {.velocity = {speed, 0, 0}}, {.from = 1.0});
            scene.build();
            if (rests) scene.world.rest = std::make_unique<Rest>();
            for (int i = 0; i < 60; ++i) scene.world.step(ContactScene::dt);
            if (rests) REQUIRE(scene.world.rest->is_at_rest(2));
            while (scene.world.bodies[0].position.x() < 3.0) scene.world.step(ContactScene::dt);
            scene.world.step(ContactScene::dt);  // it may have been met in the last one, and lie a part of it
            INFO(speed << " m/s, rest " << rests);
            const double ahead = scene.world.bodies[2].position.x() - scene.world.bodies[0].position.x();
            CHECK(ahead > 0.14);
            CHECK(velocity(scene.world.bodies[2]).x() > 0.99 * speed);
        }
    }
}

TEST_CASE("a pendulum on a point that moves to and fro swings like the driven oscillator") {
    const double length = 1.0, amplitude = 0.002, frequency = 0.3, dt = 1.0 / 480.0;
    const double omega = 2.0 * pi * frequency, own = std::sqrt(g / length);
    for (const bool ball_joint : {false, true}) {
        World world;
        world.bodies = {static_body({0, 2, 0}), ball_body(1.0, 0.01, {0, 1, 0})};
        world.forces.push_back(std::make_unique<Gravity>(Vector3(0, -g, 0)));
        Distance bar{.body_a = 0, .body_b = 1, .length = length};
        if (ball_joint) {
            bar.length = 0.0;
            bar.point_b = {0, length, 0};
        }
        world.constraints.push_back(
            std::make_unique<DistanceConstraints>(std::vector{bar}, Correction{PushKind::persistent, 1.0}, true));
        world.solver = solvers::make_solver("auto");
        world.termination = {.iterations = 25, .tolerance_high = 1e-12, .tolerance_low = 1e-13};
        world.move(0, std::make_unique<Oscillation>(place_of(world.bodies[0]), Vector3(amplitude, 0, 0), frequency,
                                                    0.0, PathTimes{}));
        // With the moment of inertia of the ball about its centre, if it turns with the joint.
        const double lever = ball_joint ? length + 0.4 * 0.01 * 0.01 / length : length;
        const double swing = ball_joint ? std::sqrt(g / lever) : own;
        double worst = 0.0;
        while (world.time() < 10.0) {
            world.step(dt);
            // x'' + w0^2 (x - a sin wt) = 0 from rest.
            const double t = world.time(), share = swing * swing / (swing * swing - omega * omega);
            const double x = amplitude * share * (std::sin(omega * t) - omega / swing * std::sin(swing * t));
            worst = std::max(worst, std::abs(world.bodies[1].position.x() - x));
        }
        INFO("ball joint " << ball_joint);
        CHECK(worst < 1e-3 * amplitude);
    }
}

TEST_CASE("a bar on a body that turns about the bar's end hangs still") {
    const double rate = 4.0, dt = 1.0 / 240.0;
    World world;
    world.bodies = {static_body({0, 2, 0}), ball_body(1.0, 0.01, {0, 1, 0})};
    world.forces.push_back(std::make_unique<Gravity>(Vector3(0, -g, 0)));
    world.constraints.push_back(
        std::make_unique<DistanceConstraints>(std::vector{Distance{.body_a = 0, .body_b = 1, .length = 1.0}},
                                              Correction{PushKind::persistent, 1.0}, true));
    world.solver = solvers::make_solver("auto");
    world.termination = {.iterations = 25, .tolerance_high = 1e-12, .tolerance_low = 1e-13};
    world.move(
        0, std::make_unique<SteadyPath>(place_of(world.bodies[0]), Motion{{0, 0, 0}, {1, rate, 2}}, PathTimes{}));
    for (int i = 0; i < 1000; ++i) world.step(dt);
    CHECK((world.bodies[1].position - Vector3(0, 1, 0)).norm() < 1e-6);
}

TEST_CASE("a table of places carries a cube to where it says") {
    ContactScene scene;
    scene.add_plate({2, 0.2, 2}, {0, -0.1, 0}, {.friction = 1.0});
    scene.add_box(Vector3::Constant(0.5), {0.3, 0.25, 0}, {0, 0, 0}, {.friction = 1.0});
    const Place start = place_of(scene.world.bodies[0]);
    const Place end{{3, 1, -1}, turned(2.5)};
    std::vector<PlaceTable::Entry> entries;
    for (int i = 1; i < 40; ++i) {  // slowly enough for friction
        const double share = 0.5 - 0.5 * std::cos(pi * i / 40);
        const Vector3 way = end.position - start.position;
        entries.push_back({0.2 * i, {start.position + share * way, turned(2.5 * share)}});
    }
    entries.push_back({8.0, end});
    scene.world.move(0, std::make_unique<PlaceTable>(start, entries));
    scene.build();
    while (scene.world.time() < 9.0) scene.world.step(ContactScene::dt);
    CHECK(scene.world.bodies[0].position == end.position);
    CHECK(scene.world.bodies[0].orientation.coeffs() == end.orientation.coeffs());
    const Vector3 expected = end.position + end.orientation * Vector3(0.3, 0.35, 0);
    CHECK((scene.world.bodies[1].position - expected).norm() < 1e-3);
    CHECK(scene.world.bodies[1].orientation.angularDistance(end.orientation) < 1e-3);
}

TEST_CASE("what a moved body meets within a step ends that step at its surface") {
    for (const Under what : all_under) {
        for (const bool turns : {false, true}) {
            if (turns && what == Under::ball) continue;
            ContactScene scene;
            add_under(scene, what, {.friction = 0.0});
            scene.add_ball(0.25, {turns ? 0.5 : 0.0, turns ? 0.28 : 0.88, 0}, {0, 0, 0}, {.friction = 0.0});
            const Motion rise{.velocity = {0, 6, 0}}, tilt{.angular_velocity = {0, 0, 3}};
            move(scene, 0, turns ? tilt : rise);
            scene.build(Vector3::Zero());
            double deepest = 0.0;
            for (int i = 0; i < 12; ++i) {
                scene.world.step(ContactScene::dt);
                deepest = std::max(deepest, scene.penetration());
            }
            INFO("kind " << static_cast<int>(what) << ", turns " << turns);
            CHECK(deepest < (turns ? 0.01 : 1e-9));  // along a line, not an arc
            CHECK(velocity(scene.world.bodies[1]).norm() > 1.0);
        }
    }
}

TEST_CASE("all is the same seen from a frame that moves along") {
    // A cube that slides on a plate which moves, and one that slides the other way on one that stands.
    const Vector3 plate(0.7, 0, -0.4), cube(2, 0, 1);
    std::array<Vector3, 2> ends;
    for (const bool moves : {false, true}) {
        ContactScene scene;
        scene.add_plate({20, 1, 20}, {0, -0.5, 0});
        scene.add_box(Vector3::Ones(), {0, 0.5, 0}, moves ? cube : Vector3(cube - plate));
        if (moves) move(scene, 0, {.velocity = plate});
        scene.build();
        for (int i = 0; i < 60; ++i) scene.world.step(ContactScene::dt);
        ends[moves] = scene.world.bodies[1].position - scene.world.bodies[0].position;
    }
    CHECK((ends[0] - ends[1]).norm() < 1e-9);
    CHECK(ends[0].norm() > 0.1);
}
