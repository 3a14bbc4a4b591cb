// Elastic collisions, paper section 8.2, and the lasting push: a conveyor (8.1, "constant speed motors").
#include "engine/constraints/contact_constraints.h"
#include "engine/constraints/contact_row.h"
#include "engine/forces/gravity.h"
#include "engine/forces/poke.h"
#include "engine/world.h"
#include "tests/catch.h"
#include "tests/engine/contact_scene.h"
#include "tests/random.h"

#include <cmath>

using namespace pushfactor::engine;
using pushfactor::tests::ContactScene;
using pushfactor::tests::Random;

namespace {

const Vector3 gravity(0, -10, 0);
constexpr double dt = 1.0 / 60.0;

struct Floor {
    double restitution = 0.0;
    RestitutionRule rule = nullptr;  // null: impacts in the order in which they happen
    Correction correction{PushKind::single_frame, 0.2};
    Vector3 belt = Vector3::Zero();
    double friction = 0.0;
};

World above_floor(const Body& body, const collision::Shape& shape, const Floor& floor) {
    World world;
    world.bodies = {static_body(Vector3::Zero()), body};
    world.forces.push_back(std::make_unique<Gravity>(gravity));
    auto stage = std::make_unique<ContactConstraints>(
        std::vector<collision::Collider>{{.body = 0,
                                          .shape = collision::Plane{},
                                          .friction = floor.friction,
                                          .restitution = floor.restitution,
                                          .surface_velocity = floor.belt},
                                         {.body = 1, .shape = shape, .friction = floor.friction}},
        ContactChoices{.correction = floor.correction, .slop = 0.002, .detection = {.margin = 0.0}});
    stage->set_restitution(floor.rule);
    if (!floor.rule) world.impacts = std::make_unique<Impacts>(*stage);
    if (floor.friction > 0.0) stage->set_friction(coulomb_friction);
    stage->set_cache(std::make_unique<ContactCache>());
    world.constraints.push_back(std::move(stage));
    world.solver = solvers::make_solver("pgs");
    world.termination = {.iterations = 1000, .tolerance_high = 1e-12, .tolerance_low = 1e-12};
    return world;
}

// Heights of the first bounces of a ball dropped by 2 m, above its resting height.
std::vector<double> apexes(const Floor& floor, std::size_t count) {
    World world = above_floor(ball_body(1.0, 0.5, {0, 2.5, 0}), collision::Sphere{0.5}, floor);
    std::vector<double> heights;
    double before = 0.0;
    for (int n = 0; n < 3000 && heights.size() < count; ++n) {
        const double rising = velocity(world.bodies[1]).y();
        if (before > 0.0 && rising <= 0.0) heights.push_back(world.bodies[1].position.y() - 0.5);
        before = rising;
        world.step(dt);
    }
    return heights;
}

// Tops of the first flights after a bounce, m above the resting height, from the parabola through the positions.
std::vector<double> parabola_apexes(World& world, double resting_height, std::size_t count) {
    std::vector<double> heights;
    for (int n = 0; n < 3000 && heights.size() < count; ++n) {
        const double rising = velocity(world.bodies.back()).y();
        const double height = world.bodies.back().position.y() - resting_height;
        world.step(dt);
        if (rising <= 0.0 || velocity(world.bodies.back()).y() > 0.0) continue;
        const double speed = rising + 0.5 * gravity.y() * dt;  // with the position, not half a step before it
        heights.push_back(height + 0.5 * speed * speed / 10.0);
    }
    return heights;
}

}  // namespace

TEST_CASE("8.2.1: the rebound is epsilon times the speed before the step, without this step's gravity") {
    World world = above_floor(ball_body(1.0, 0.5, {0, 0.499, 0}), collision::Sphere{0.5},
                              {.restitution = 0.7, .rule = restitution_sum});
    world.bodies[1].linear_momentum = {0, -4, 0};
    world.step(dt);
    CHECK(velocity(world.bodies[1]).y() == Approx(2.8));
}

TEST_CASE("with epsilon 1 every bounce is as high as the first, without the push") {
    World world = above_floor(ball_body(1.0, 0.5, {0, 2.5, 0}), collision::Sphere{0.5}, {.restitution = 1.0});
    const auto heights = parabola_apexes(world, 0.5, 5);
    REQUIRE(heights.size() == 5);
    for (const double height : heights) CHECK(height == Approx(2.0 + 10.0 * dt * dt / 8.0).epsilon(1e-9));
}

TEST_CASE("the sum of push and rebound, as 8.2 has it, gains height at every bounce") {
    const auto heights = apexes({.restitution = 1.0, .rule = restitution_sum}, 5);
    REQUIRE(heights.size() == 5);
    for (std::size_t i = 1; i < heights.size(); ++i) CHECK(heights[i] > heights[i - 1]);
    // And far more under the persistent push: measured 2.57, 3.60, ... m.
    const auto persistent =
        apexes({.restitution = 1.0, .rule = restitution_sum, .correction = {PushKind::persistent, 0.2}}, 5);
    CHECK(persistent.back() > 1.5 * heights.back());
}

TEST_CASE("a ball with restitution that lies on the floor stays there") {
    for (const RestitutionRule rule : {RestitutionRule(nullptr), RestitutionRule(restitution_sum)}) {
        World world = above_floor(ball_body(1.0, 0.5, {0, 0.499, 0}), collision::Sphere{0.5},
                                  {.restitution = 0.9, .rule = rule});
        for (int n = 0; n < 300; ++n) {
            world.step(dt);
            REQUIRE(std::abs(velocity(world.bodies[1]).y()) < 1e-9);
        }
    }
}

TEST_CASE("8.2: separating contacts get no rebound, and a point in the margin only if it would meet") {
    const PushFactor push{.correcting = 0.1, .lasting = 0.0};
    CHECK(restitution_sum(push, {.speed = 2.0, .acceleration = -10, .gap = -0.01, .restitution = 1, .dt = dt})
              .lasting == 0.0);
    const PushFactor margin{.correcting = 0.0, .lasting = -0.1 / dt};
    Impact impact{.speed = -4, .acceleration = -10, .gap = 0.1, .restitution = 1, .dt = dt};
    CHECK(restitution_sum(margin, impact).lasting == margin.lasting);
    impact.speed = -8;
    CHECK(restitution_sum(margin, impact).lasting == 8.0);
}

TEST_CASE("a bounce within a step follows two parabolas that meet on the ground") {
    const double a = -10.0, gap = 0.07, epsilon = 0.6, v = -6.0;  // v at the start of the step
    ContactScene scene;
    scene.add_ground();
    scene.add_ball(0.1, {0, 0.1 + gap, 0}, {0, v - 0.5 * a * dt, 0}, {.restitution = epsilon});
    scene.build();
    scene.world.step(dt);
    // Down to the ground, then up with epsilon times the speed to the end of the step.
    const double down = -std::sqrt(v * v - 2.0 * a * gap);
    const double rest = dt - (down - v) / a;
    CHECK(scene.world.bodies[1].position.y() - 0.1 ==
          Approx(-epsilon * down * rest + 0.5 * a * rest * rest).epsilon(1e-12));
    // The momenta belong half a step earlier.
    CHECK(velocity(scene.world.bodies[1]).y() == Approx(-epsilon * down + a * rest - 0.5 * a * dt).epsilon(1e-12));
}

TEST_CASE("bounces reach epsilon squared of the height before, whatever the phase of the step") {
    for (const double height : {2.0, 1.93, 1.87}) {
        for (const double epsilon : {1.0, 0.5}) {
            ContactScene scene;
            scene.add_ground();
            scene.add_ball(0.1, {0, 0.1 + height, 0}, {0, 0, 0}, {.restitution = epsilon});
            scene.build();
            const auto apexes = parabola_apexes(scene.world, 0.1, 4);
            REQUIRE(apexes.size() == 4);
            // A drop from rest begins with the momentum of half a step later, as if it came from above.
            double expected = height + 10.0 * dt * dt / 8.0;
            for (const double apex : apexes) {
                expected *= epsilon * epsilon;
                CHECK(apex == Approx(expected).margin(1e-9));
            }
        }
    }
}

TEST_CASE("a cube and an uneven box that fall flat bounce to epsilon squared of the height") {
    for (const Vector3& size : {Vector3(1, 1, 1), Vector3(1, 0.4, 0.2)}) {
        ContactScene scene;
        scene.add_ground();
        scene.add_box(size, {0, 2.0 + 0.5 * size.y(), 0}, {0, 0, 0}, {.restitution = 0.5});
        scene.build();
        const auto apexes = parabola_apexes(scene.world, 0.5 * size.y(), 3);
        REQUIRE(apexes.size() == 3);
        const double start = 2.0 + 10.0 * dt * dt / 8.0;
        CHECK(apexes[0] == Approx(start / 4.0));
        CHECK(apexes[1] == Approx(start / 16.0));
        CHECK(apexes[2] == Approx(start / 64.0));
    }
}

TEST_CASE("a tumbling box that bounces for 20 s without friction keeps its energy") {
    for (const double height : {2.0, 2.1, 2.3}) {
        for (const Vector3& spin : {Vector3(1, 4, 3), Vector3(3, 2.5, -2)}) {
            ContactScene scene;
            scene.add_ground({.friction = 0.0});
            Body& box = scene.add_box({1, 0.4, 0.2}, {0, height, 0}, {0, 0, 0}, {.friction = 0, .restitution = 1});
            box.angular_momentum = box.inverse_inertia.cwiseInverse().cwiseProduct(spin);
            scene.build();
            // The momenta belong half a step earlier than the positions.
            const auto energy = [&] {
                std::vector<Body> bodies = scene.world.bodies;
                bodies[1].linear_momentum += 0.5 * dt * gravity;
                return kinetic_energy(bodies) + potential_energy(bodies, gravity);
            };
            const double before = energy();
            scene.watch(1200);
            CHECK(energy() == Approx(before).epsilon(1e-3));  // measured within 5e-5
        }
    }
}

TEST_CASE("elastic balls that fly about in a box make no energy of many collisions in one step") {
    Random random(3);
    ContactScene scene;
    scene.add_closed_box({.friction = 0.0});
    for (int i = 0; i < 12; ++i) {
        const Vector3 place(-2 + (i % 3) * 2, -2 + (i / 3 % 2) * 2, -2 + (i / 6) * 2);
        const double radius = random.in(0.1, 0.5);
        scene.add_ball(radius, place, random.vector(-100, 100), {.friction = 0, .restitution = 1});
    }
    scene.build(Vector3::Zero());
    const double before = kinetic_energy(scene.world.bodies);
    for (int n = 0; n < 300; ++n) {
        scene.world.step(dt);
        REQUIRE(kinetic_energy(scene.world.bodies) < before * (1.0 + 1e-9));
    }
}

// In the last millimetre a slow ball takes many steps to close what counts as touching.
TEST_CASE("without gravity any approach bounces, however slow, large or finely divided") {
    for (const double epsilon : {0.5, 1.0}) {
        for (const double radius : {0.01, 1.0, 100.0}) {
            for (const double speed : {1e-6, 1e-4, 1e-2}) {  // radii per second
                for (const double step : {1.0 / 60.0, 1e-3, 1e-4}) {
                    ContactScene scene;
                    const double gap = 300.5 * step * speed * radius;
                    scene.add_ball(radius, {0, 0, 0}, {speed * radius, 0, 0},
                                   {.friction = 0, .restitution = epsilon});
                    scene.add_ball(radius, {2.0 * radius + gap, 0, 0}, {0, 0, 0}, {.friction = 0});
                    scene.build({0, 0, 0});
                    scene.world.termination.tolerance_high = scene.world.termination.tolerance_low = 1e-16;
                    for (int i = 0; i < 900; ++i) scene.world.step(step);
                    INFO("epsilon " << epsilon << ", radius " << radius << ", " << speed << ", step " << step);
                    CHECK(velocity(scene.world.bodies[1]).x() ==
                          Approx(0.5 * (1.0 + epsilon) * speed * radius).epsilon(1e-6));
                    CHECK(velocity(scene.world.bodies[0]).x() ==
                          Approx(0.5 * (1.0 - epsilon) * speed * radius).margin(1e-6 * speed * radius));
                }
            }
        }
    }
}

TEST_CASE("a smaller step loses no bounce, down to one as high as the gap that counts as touching") {
    const double radius = 0.1, touching = 1e-3 * 0.002 * 2.0 * radius;
    for (const double height : {0.5 * touching, 4.0 * touching, 100.0 * touching, 1e4 * touching}) {
        for (const double share : {0.2, 0.02, 0.002}) {  // of the time of the fall
            const double falls = std::sqrt(2.0 * height / 10.0), step = share * falls;
            ContactScene scene;
            scene.add_ground({.friction = 0, .restitution = 1.0});
            scene.add_ball(radius, {0, radius + height, 0}, {0, 0, 0}, {.friction = 0});
            scene.build();
            scene.world.kick_back_half(step);
            double highest = 0.0;  // after the bounce
            while (scene.world.time() < 3.0 * falls) {
                scene.world.step(step);
                if (scene.world.time() > 1.3 * falls)
                    highest = std::max(highest, scene.world.bodies[1].position.y() - radius);
            }
            INFO("height " << height << ", share " << share);
            if (height > touching) {
                CHECK(highest == Approx(height).epsilon(0.05));
            } else {
                CHECK(highest < 1.001 * height);
                CHECK(velocity(scene.world.bodies[1]).norm() < 10.0 * 3.0 * falls);
            }
        }
    }
}

// Their rebounds meet each other within a step, which leaves speeds of some steps of weight.
TEST_CASE("a stack of elastic cubes that falls comes to rest, the more the smaller the steps are") {
    for (const double step : {1.0 / 60.0, 1.0 / 1000.0, 1.0 / 5000.0}) {
        ContactScene scene;
        scene.add_ground({.friction = 0.5, .restitution = 0.5});
        for (int i = 0; i < 4; ++i) {
            scene.add_box(Vector3::Constant(0.5), {0, 0.25 + 0.05 + 0.55 * i, 0}, {0, 0, 0},
                          {.friction = 0.5, .restitution = 0.5});
        }
        scene.build();
        while (scene.world.time() < 2.0) scene.world.step(step);
        INFO("step " << step);
        CHECK(max_speed(scene.world.bodies) < 6.0 * 10.0 * step);
        if (step == 1.0 / 5000.0) CHECK(max_speed(scene.world.bodies) < 1e-6);
    }
}

TEST_CASE("a stack of elastic cubes that lies on the ground stays there") {
    ContactScene scene;
    scene.add_ground();
    for (int i = 0; i < 5; ++i) {
        scene.add_box(Vector3::Ones(), {0, (0.5 + i) * (1.0 - 1e-4), 0}, {0, 0, 0}, {.restitution = 1});
    }
    scene.build();
    CHECK(scene.watch(600).speed_at_end < 1e-6);
    CHECK(scene.world.bodies[5].position.y() == Approx(4.5).margin(1e-3));
}

TEST_CASE("a belt brings a box up to its speed at mu g and carries it on") {
    const double mu = 0.4;
    World world = above_floor(box_body(2.0, Vector3::Ones(), {0, 0.5 - 1e-4, 0}),
                              collision::Box{Vector3::Constant(0.5)}, {.belt = Vector3(1.5, 0, 0), .friction = mu});
    for (int n = 1; n <= 120; ++n) {
        world.step(dt);
        const double expected = std::min(1.5, mu * 10.0 * n * dt);
        REQUIRE(velocity(world.bodies[1]).x() == Approx(expected).margin(1e-6));
    }
    CHECK(std::abs(velocity(world.bodies[1]).z()) < 1e-9);
}

TEST_CASE("a poke begins and ends at its times and moves its body alone") {
    World world;
    world.bodies = {ball_body(2.0, 0.5, Vector3::Zero()), ball_body(2.0, 0.5, {5, 0, 0})};
    world.forces.push_back(
        std::make_unique<PokeForce>(Poke{.body = 1, .force = {0, 0, 6}, .from = 0.5, .until = 1.5}));
    for (int n = 0; n < 30; ++n) world.step(dt);
    CHECK(velocity(world.bodies[1]).z() == 0.0);
    for (int n = 0; n < 120; ++n) world.step(dt);
    CHECK(velocity(world.bodies[1]).z() == Approx(3.0));  // 6 N on 2 kg for exactly 60 steps
    CHECK(velocity(world.bodies[0]).norm() == 0.0);
}
