// Rebounds with friction make no energy.
#include "engine/collision/collider.h"
#include "engine/impacts/impacts.h"
#include "tests/catch.h"
#include "tests/engine/contact_scene.h"
#include "tests/random.h"

#include <cmath>
#include <memory>

using namespace pushfactor::engine;
using namespace pushfactor::tests;

namespace {

// A step in which nothing turns by more than rounding.
constexpr double instant = 1e-9;

// Boxes, rods, and octahedra with unequal axes.
collision::Shape random_shape(Random& random, int kind) {
    if (kind == 0) return collision::Box{random.vector(0.1, 1.0)};
    if (kind == 1) return collision::Box{{random.in(0.3, 1.0), 0.05, 0.05}};
    const Vector3 reach = random.vector(0.2, 1.0);
    std::vector<Vector3> vertices;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) vertices.push_back(side * reach[axis] * Vector3::Unit(axis));
    }
    std::vector<std::vector<int>> faces;
    for (const int x : {0, 1}) {
        for (const int y : {2, 3}) {
            for (const int z : {4, 5}) {
                if ((x + y + z) % 2 == 1) {
                    faces.push_back({x, y, z});
                } else {
                    faces.push_back({x, z, y});
                }
            }
        }
    }
    return collision::Polyhedron{std::make_shared<collision::PolyhedronMesh>(vertices, faces)};
}

// The body touches the ground with its lowest corner.
struct Drop {
    ContactScene scene;

    Drop(const collision::Shape& shape, const Vector3& moments, const Quaternion& turned, const Surface& surface) {
        scene.add_ground({.friction = surface.friction});
        const double height = collision::reach_along(shape, turned.toRotationMatrix(), {0, -1, 0});
        scene.add(solid_body(1.0, moments, {0, height, 0}, turned), shape, surface);
    }
    void spin(const Vector3& velocity, const Vector3& rate) {
        Body& body = scene.world.bodies[1];
        body.linear_momentum = velocity;
        const Vector3 own = body.orientation.conjugate() * rate;
        body.angular_momentum = body.orientation * own.cwiseQuotient(body.inverse_inertia);
    }
};

}  // namespace

TEST_CASE("no impact of 10000 boxes, rods and octahedra with friction makes energy, and ideal ones lose none") {
    Random random(11);
    int impacts = 0;
    for (int trial = 0; trial < 10000; ++trial) {
        const bool ideal = trial % 10 == 0;
        const Surface surface{.friction = ideal ? 0.0 : random.in(0.0, 4.0),
                              .restitution = ideal || trial % 3 == 0 ? 1.0 : random.in(0.0, 1.0)};
        Drop drop(random_shape(random, trial % 3), random.vector(0.05, 0.09), random.rotation(), surface);
        drop.spin(random.vector(-4.0, 4.0) - Vector3(0, 5, 0), random.vector(-8.0, 8.0));
        drop.scene.build(Vector3::Zero());
        const double before = kinetic_energy(drop.scene.world.bodies);
        drop.scene.world.step(instant);
        const double after = kinetic_energy(drop.scene.world.bodies);
        if (drop.scene.world.impacts) impacts += drop.scene.world.impacts->count();
        INFO("trial " << trial << ", friction " << surface.friction << ", restitution " << surface.restitution);
        REQUIRE(after <= before * (1.0 + 1e-9));
        if (ideal) REQUIRE(after >= before * (1.0 - 1e-9));
    }
    CHECK(impacts > 5000);
}

// By Newton's law, sticking, a sixth more than before.
TEST_CASE("a rod whose sliding friction would turn around leaves an elastic impact with the energy that it had") {
    for (const double restitution : {1.0, 0.9}) {
        const Quaternion turned(Eigen::AngleAxisd(0.698, Vector3::UnitZ()));
        Drop drop(collision::Box{{0.5, 0.05, 0.05}},
                  box_body(1.0, {1.0, 0.1, 0.1}, Vector3::Zero()).inverse_inertia.cwiseInverse(), turned,
                  {.friction = 4.0, .restitution = restitution});
        drop.spin({1.8266, -3.0, 0}, Vector3::Zero());
        drop.scene.build(Vector3::Zero());
        const double start = kinetic_energy(drop.scene.world.bodies);
        drop.scene.world.step(instant);
        REQUIRE(drop.scene.world.impacts->count() == 1);
        CHECK(velocity(drop.scene.world.bodies[1]).y() > -0.5);
        CHECK(kinetic_energy(drop.scene.world.bodies) == Approx(start).epsilon(1e-9));
    }
}
