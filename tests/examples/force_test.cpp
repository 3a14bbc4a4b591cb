// A force source, as engine/README.md shows it.
#include "engine/forces/force_source.h"
#include "engine/world.h"
#include "tests/catch.h"

#include <cmath>

using namespace pushfactor::engine;

namespace {

// [example: force]
// Air that slows bodies down: f = -c v.
class Drag : public ForceSource {
  public:
    explicit Drag(double drag) : drag_(drag) {}  // c, N s/m, >= 0

    void add_forces(const ForcedBodies& bodies, double /*from*/, double /*until*/) override {
        for (Body& body : bodies) body.force -= drag_ * velocity(body);
    }

  private:
    double drag_;
};
// [end]

}  // namespace

TEST_CASE("example: a body that drag slows down follows v_n = v_0 (1 - c dt / m)^n") {
    const double mass = 3.0, drag = 0.6, dt = 0.01;
    World world;
    world.bodies = {static_body(Vector3::Zero()), ball_body(mass, 0.5, Vector3(0, 1, 0))};
    world.bodies[1].linear_momentum = mass * Vector3(2, -4, 1);
    world.forces.push_back(std::make_unique<Drag>(drag));
    for (int n = 1; n <= 1000; ++n) {
        world.step(dt);
        const double share = std::pow(1.0 - drag * dt / mass, n);
        CHECK((velocity(world.bodies[1]) - share * Vector3(2, -4, 1)).norm() < 1e-12);
    }
    CHECK(world.bodies[0].position == Vector3::Zero());
}
