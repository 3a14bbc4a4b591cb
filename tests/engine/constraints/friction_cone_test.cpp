// Coulomb friction on a round cone: the same in every direction and at every step length, and none without a
// contact.
#include "engine/constraints/friction_row.h"
#include "tests/catch.h"
#include "tests/engine/contact_scene.h"
#include "tests/engine/random_contacts.h"

#include <cmath>
#include <numbers>

using namespace pushfactor::engine;
using namespace pushfactor::tests;

namespace {

constexpr double dt = ContactScene::dt;
constexpr double g = 10.0;
constexpr double mu = 0.3;
constexpr double pi = std::numbers::pi;

Quaternion turned(double angle, const Vector3& axis = Vector3::UnitY()) {
    return Quaternion(Eigen::AngleAxisd(angle, axis));
}

Vector3 level(double angle) {
    return {std::cos(angle), 0, std::sin(angle)};
}

void run(ContactScene& scene, double seconds, int substeps = 1) {
    const int steps = static_cast<int>(std::lround(seconds / dt)) * substeps;
    for (int i = 0; i < steps; ++i) scene.world.step(dt / substeps);
}

// A cube of 1 m that lies on the ground and moves with `velocity`.
Body& add_cube(ContactScene& scene, const Vector3& velocity, double turn = 0.0) {
    scene.add_ground({.friction = mu});
    Body& cube = scene.add_box(Vector3::Ones(), {0, 0.5, 0}, velocity, {.friction = mu});
    cube.orientation = turned(turn);
    return cube;
}

}  // namespace

TEST_CASE("a pair without friction has no rows of friction, and goes on beside one that has some") {
    ContactScene scene;
    add_cube(scene, {1, 0, 0});
    scene.add_ball(0.5, {0, 0.5, 5}, {1, 0, 0}, {.friction = 0.0});
    scene.build();
    scene.world.step(dt);
    int of_cube = 0, of_ball = 0;
    for (const ConstraintRow& row : scene.world.rows()) {
        if (row.label.kind == RowKind::friction) ++(row.body_a == 2 || row.body_b == 2 ? of_ball : of_cube);
    }
    CHECK(of_cube == 8);
    CHECK(of_ball == 0);
    run(scene, 0.1);
    CHECK(velocity(scene.world.bodies[1]).x() < 0.7);
    CHECK(velocity(scene.world.bodies[2]).x() == 1.0);
}

TEST_CASE("a cube slides v^2 / (2 mu g) far in every direction, straight on and without turning, at any step") {
    Random random(18);
    for (const int substeps : {1, 4, 16}) {
        for (int i = 0; i < 8; ++i) {
            const double angle = random.in(0, 2 * pi), turn = random.in(0, 2 * pi), speed = random.in(0.5, 4);
            ContactScene scene;
            add_cube(scene, speed * level(angle), turn);
            scene.build();
            run(scene, 2.0, substeps);
            INFO("angle " << angle << ", turned by " << turn << ", " << speed << " m/s, " << substeps
                          << " substeps");
            const Body& cube = scene.world.bodies[1];
            CHECK(std::abs(cube.position.dot(level(angle)) - speed * speed / (2 * mu * g)) < speed * dt / substeps);
            CHECK(std::abs(cube.position.dot(level(angle + 0.5 * pi))) < 1e-6);
            CHECK(cube.orientation.angularDistance(turned(turn)) < 1e-6);
            CHECK(velocity(cube).norm() < 1e-9);
        }
    }
}

TEST_CASE("sliding friction takes mu g t off the speed, with 1 to 64 substeps") {
    for (const int substeps : {1, 4, 16, 64}) {
        for (const double angle : {0.0, 0.3, 0.25 * pi}) {
            ContactScene scene;
            add_cube(scene, 0.3 * level(angle));
            scene.build();
            run(scene, 0.05, substeps);
            INFO(substeps << " substeps at " << angle);
            const Vector3 left = velocity(scene.world.bodies[1]);
            CHECK(left.x() == Approx(0.15 * std::cos(angle)).margin(1e-6));
            CHECK(left.z() == Approx(0.15 * std::sin(angle)).margin(1e-6));
        }
    }
}

TEST_CASE("on a slope a turned cube sticks below atan(mu) for a minute, and slides at g (sin - mu cos) above") {
    for (const double turn : {0.0, 0.3, 0.25 * pi}) {
        for (const double angle : {0.95 * std::atan(mu), 1.05 * std::atan(mu), 0.5}) {
            INFO("slope " << angle << ", turned by " << turn);
            ContactScene scene;
            add_cube(scene, Vector3::Zero(), turn);
            scene.build(g * Vector3(std::sin(angle), -std::cos(angle), 0));
            const double expected = g * (std::sin(angle) - mu * std::cos(angle));
            run(scene, 1.0);
            const Vector3 after_a_second = scene.world.bodies[1].position;
            if (expected > 0.0) {
                CHECK(std::abs(velocity(scene.world.bodies[1]).x() - expected) < 1e-6);
                CHECK(std::abs(velocity(scene.world.bodies[1]).z()) < 1e-6);
                continue;
            }
            run(scene, 60.0);
            CHECK((scene.world.bodies[1].position - after_a_second).norm() < 1e-9);
        }
    }
}

TEST_CASE("a ball on a slope rolls at 5/7 g sin, or slips at g (sin - mu cos) where tan exceeds 7/2 mu") {
    for (const double angle : {0.2, 0.7, 0.9, 1.2}) {
        INFO("slope " << angle);
        ContactScene scene;
        scene.add_ground({.friction = mu});
        scene.add_ball(0.5, {0, 0.5, 0}, {0, 0, 0}, {.friction = mu});
        const Vector3 down = level(0.4);
        scene.build(g * (std::sin(angle) * down - std::cos(angle) * Vector3::UnitY()));
        run(scene, 1.0);
        const bool slips = std::tan(angle) > 3.5 * mu;
        const double expected =
            slips ? g * (std::sin(angle) - mu * std::cos(angle)) : 5.0 / 7.0 * g * std::sin(angle);
        const Vector3 reached = velocity(scene.world.bodies[1]);
        CHECK((reached - expected * down).norm() < 1e-6);
    }
}

TEST_CASE("a sliding ball begins to roll after 2 v / (7 mu g), at 5/7 of its speed, in its direction") {
    const double speed = 2.1;
    const double begins = 2.0 * speed / (7.0 * mu * g);  // 0.2 s
    for (const int substeps : {1, 16}) {
        ContactScene scene;
        scene.add_ground({.friction = mu});
        scene.add_ball(0.5, {0, 0.5, 0}, speed * level(0.7), {.friction = mu});
        scene.build();
        run(scene, begins - 2 * dt, substeps);
        CHECK(velocity(scene.world.bodies[1]).norm() == Approx(speed - mu * g * (begins - 2 * dt)).margin(1e-6));
        run(scene, 1.0, substeps);
        const Body& ball = scene.world.bodies[1];
        CHECK((velocity(ball) - 5.0 / 7.0 * speed * level(0.7)).norm() < 1e-6);
        CHECK(angular_velocity(ball).cross(Vector3(0, -0.5, 0)).isApprox(-velocity(ball), 1e-6));
    }
}

TEST_CASE("a cube that spins on its four corners stops as mu m g r says") {
    const double rate = 8.0, r = std::sqrt(0.5);
    const double slows = mu * g * r * 6.0;  // rad/s^2, with I = m / 6 m^2
    for (const int substeps : {1, 16}) {
        ContactScene scene;
        Body& cube = add_cube(scene, Vector3::Zero());
        cube.angular_momentum = Vector3(0, rate / 6.0, 0);
        scene.build();
        double angle = 0.0;
        for (int i = 0; i < 120 * substeps; ++i) {
            scene.world.step(dt / substeps);
            angle += angular_velocity(scene.world.bodies[1]).y() * dt / substeps;
        }
        CHECK(std::abs(angle - rate * rate / (2 * slows)) < rate * dt / substeps);
        CHECK(angular_velocity(scene.world.bodies[1]).norm() < 1e-9);
        CHECK((scene.world.bodies[1].position - Vector3(0, 0.5, 0)).norm() < 1e-5);
    }
}

TEST_CASE("a slab that slides and spins goes 2.80 m, whatever the step") {
    for (const int substeps : {1, 4, 16}) {
        ContactScene scene;
        scene.add_ground({.friction = mu});
        Body& slab = scene.add_box({1, 0.2, 1}, {0, 0.1, 0}, {3, 0, 0}, {.friction = mu});
        slab.angular_momentum = Vector3(0, 10.0 / 6.0, 0);
        scene.build({0, -9.81, 0});
        run(scene, 3.0, substeps);
        INFO(substeps << " substeps");
        // To first order in the step: the error is half of the distance covered in one step.
        CHECK(std::abs(scene.world.bodies[1].position.norm() - 2.82) < 0.02 + 3.0 * dt / substeps);
        CHECK(velocity(scene.world.bodies[1]).norm() < 1e-9);
    }
}

TEST_CASE("a cube that hovers in the margin keeps its speed, whatever the rule of friction") {
    const Vector3 gravity(0, -g, 0);
    for (int rule = 0; rule < 3; ++rule) {
        World world;
        world.bodies = {static_body(Vector3::Zero()), box_body(1.0, Vector3::Ones(), {0, 0.505, 0})};
        world.bodies[1].linear_momentum = {1, 0, 0};
        auto stage = std::make_unique<ContactConstraints>(
            std::vector<collision::Collider>{{.body = 0, .shape = collision::Plane{}},
                                             {.body = 1, .shape = collision::Box{}}},
            ContactChoices{.correction = {}, .detection = {.margin = 0.01}});
        if (rule == 0) stage->set_friction(weight_friction(gravity));
        if (rule == 1) stage->set_friction(coulomb_friction);
        if (rule == 2) stage->set_friction(cone_friction);
        world.constraints.push_back(std::move(stage));
        world.solver = solvers::make_solver("auto");
        world.termination = {.iterations = 25, .tolerance_high = 1e-8, .tolerance_low = 1e-10};
        for (int i = 0; i < 60; ++i) REQUIRE(world.step(dt).rows(RowKind::friction) == 8);
        INFO("rule " << rule);
        CHECK((velocity(world.bodies[1]) - Vector3(1, 0, 0)).norm() < 1e-12);
        CHECK(angular_velocity(world.bodies[1]).norm() < 1e-12);
    }
}

TEST_CASE("friction points against the sliding and is mu times the normal force, in every solver") {
    for (const char* solver : {"pgs", "nncg", "jacobi", "dense", "direct", "auto"}) {
        int sliding = 0;
        for (std::uint64_t seed = 1; seed <= 12; ++seed) {
            const Frozen frozen = random_contacts(seed, RandomFriction::cone, 0.5);
            if (frozen.rows.size() > 150) continue;
            Columns lambda = frozen.zero();
            const solvers::Termination to_the_end{
                .iterations = 20000, .tolerance_high = 1e-10, .tolerance_low = 1e-10};
            solvers::make_solver(solver)->solve(frozen.system, to_the_end, lambda);
            // Sweeps do not reach hard ones.
            if (natural_residual(frozen.system, lambda) > 1e-9) continue;
            std::vector<Vector6> forces;
            constraint_forces(frozen.system, lambda, 0, forces);
            const auto missed = [&](Eigen::Index j) {  // A lambda - b, m/s
                const ConstraintRow& row = frozen.rows[static_cast<std::size_t>(j)];
                const auto accelerated = [&](int body) {
                    const auto i = static_cast<std::size_t>(body);
                    return accelerate(frozen.system.inverse_mass[i], forces[i]);
                };
                return frozen.system.dt * (row.jacobian.a.dot(accelerated(row.body_a)) +
                                           row.jacobian.b.dot(accelerated(row.body_b)) - frozen.system.b(j, 0));
            };
            for (Eigen::Index j = 1; j < lambda.rows(); ++j) {
                const Bounds& bounds = frozen.rows[static_cast<std::size_t>(j)].bounds;
                if (bounds.disc != Disc::second) continue;
                const Eigen::Vector2d force(lambda(j - 1, 0), lambda(j, 0)), slip(missed(j - 1), missed(j));
                const double most = bounds.c_max * lambda(bounds.of_row, 0);
                INFO(solver << ", seed " << seed << ", row " << j);
                REQUIRE(force.norm() <= most * (1 + 1e-12));
                if (slip.norm() < 1e-7) continue;
                ++sliding;
                REQUIRE(force.norm() == Approx(most).epsilon(1e-6).margin(1e-9));
                REQUIRE(force.dot(slip) <= -(1 - 1e-4) * force.norm() * slip.norm() + 1e-12);
            }
        }
        INFO(solver);
        CHECK(sliding > 20);
    }
}
