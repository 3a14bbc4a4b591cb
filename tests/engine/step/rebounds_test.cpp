// Rebounds with friction: the impulses of a step, at the orientation of its start, make no energy.
#include "engine/step/rebounds.h"

#include "tests/catch.h"
#include "tests/engine/contact_scene.h"
#include "tests/random.h"

using namespace pushfactor::engine;
using namespace pushfactor::tests;

namespace {

// J, of the momenta that `now` has gained since `before`, with the inertia of `before`.
double energy_by_impulses(const Body& before, const Body& now) {
    Body kicked = before;
    kicked.linear_momentum = now.linear_momentum;
    kicked.angular_momentum = now.angular_momentum;
    const std::vector<Body> both{kicked}, one{before};
    return kinetic_energy(both) - kinetic_energy(one);
}

// A box that flies at the ground, without gravity.
struct Throw {
    ContactScene scene;

    Throw(const Vector3& size, const Quaternion& turned, const Vector3& velocity, const Vector3& spin,
          const Surface& surface) {
        scene.add_ground({.friction = surface.friction});
        Body& box = scene.add_box(size, {0, size.norm(), 0}, velocity, surface);
        box.orientation = turned;
        box.angular_momentum = turned * Vector3((turned.conjugate() * spin).cwiseQuotient(box.inverse_inertia));
        scene.build(Vector3::Zero());
    }
    const Body& box() const { return scene.world.bodies.back(); }
};

}  // namespace

TEST_CASE(
    "no impact of a box with friction and restitution makes energy, and frictionless elastic ones lose none") {
    Random random(11);
    int impacts = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const bool ideal = trial % 10 == 0;
        const Surface surface{.friction = ideal ? 0.0 : random.in(0.1, 4.0),
                              .restitution = ideal || trial % 3 == 0 ? 1.0 : random.in(0.0, 1.0)};
        Throw thrown(random.vector(0.1, 1.0), random.rotation(), random.vector(-4.0, 4.0) - Vector3(0, 5, 0),
                     random.vector(-8.0, 8.0), surface);
        for (int step = 0; step < 60; ++step) {
            const Body before = thrown.box();
            thrown.scene.world.step(1.0 / 60.0);
            const double gain = energy_by_impulses(before, thrown.box());
            const double energy = kinetic_energy(std::vector<Body>{before});
            INFO("trial " << trial << ", step " << step << ", friction " << surface.friction << ", restitution "
                          << surface.restitution);
            REQUIRE(gain <= 1e-9 * energy);
            if (ideal) REQUIRE(gain >= -1e-7 * energy);
            impacts += std::abs(gain) > 1e-6 * energy;
        }
    }
    CHECK(impacts > 1500);
}

// By Newton's law, sticking, a sixth more than before.
TEST_CASE("a rod whose sliding friction would turn around leaves an elastic impact with the energy that it had") {
    for (const double restitution : {1.0, 0.9}) {
        const Quaternion turned(Eigen::AngleAxisd(0.698, Vector3::UnitZ()));
        Throw thrown({1.0, 0.1, 0.1}, turned, {1.8266, -3.0, 0}, Vector3::Zero(),
                     {.friction = 4.0, .restitution = restitution});
        const double start = kinetic_energy(thrown.scene.world.bodies);
        for (int step = 0; step < 60; ++step) thrown.scene.world.step(1.0 / 60.0);
        CHECK(velocity(thrown.box()).y() > 0.0);
        CHECK(kinetic_energy(thrown.scene.world.bodies) <= start * (1.0 + 1e-9));
        CHECK(kinetic_energy(thrown.scene.world.bodies) > 0.8 * start);
    }
}
