#include "engine/bodies/diagnostics.h"

#include "engine/measures/penetration.h"
#include "tests/catch.h"
#include "tests/random.h"

#include <limits>

using namespace pushfactor::engine;
using pushfactor::tests::Random;

TEST_CASE("energies and momenta of one body are the textbook's") {
    Body box = box_body(2.0, {1, 1, 1}, {0, 3, 0});
    box.linear_momentum = {4, 0, 0};                // 2 m/s
    box.angular_momentum = Vector3(0, 1, 0) / 3.0;  // I = 1/3, so 1 rad/s
    const std::vector<Body> bodies{static_body(Vector3::Zero()), box};
    CHECK(kinetic_energy(bodies) == Approx(4.0 + 1.0 / 6.0));
    CHECK(potential_energy(bodies, {0, -10, 0}) == Approx(60.0));
    CHECK(max_speed(bodies) == Approx(2.0));
    CHECK(linear_momentum(bodies) == Vector3(4, 0, 0));
    CHECK((angular_momentum(bodies) - Vector3(0, 1.0 / 3.0, -12)).norm() < 1e-12);
}

TEST_CASE("a pair deepens by the increase of its own share, not by what another pair has had") {
    using Pair = Penetration::Pair;
    Penetration from, to;
    from.deep = {Pair{{0, 1}, 0.5}, Pair{{2, 3}, 0.03}};
    CHECK(deepening(from, {}) == 0.0);
    CHECK(deepening(from, from) == 0.0);
    to.deep = {Pair{{0, 1}, 0.4}, Pair{{1, 2}, 0.02}, Pair{{2, 3}, 0.06}};
    CHECK(deepening(from, to) == Approx(0.03));
    CHECK(deepening({}, to) == 0.4);
    to.deep = {Pair{{0, 1}, 0.4}, Pair{{2, 4}, 0.02}};
    CHECK(deepening(from, to) == 0.02);
}

TEST_CASE("pairs are listed that overlap by more than a hundredth of the smaller body's size") {
    const std::vector<collision::Collider> colliders{{0, collision::Sphere{1.0}}, {1, collision::Sphere{0.1}}};
    std::vector<Body> bodies{ball_body(1.0, 1.0, Vector3::Zero()), ball_body(1.0, 0.1, {1.0, 0, 0})};
    for (const double share : {0.009, 0.011, 0.3}) {
        bodies[1].position.x() = 1.1 - 0.2 * share;
        const Penetration found = penetration(bodies, colliders);
        INFO("overlap of " << share << " of 0.2 m");
        CHECK(found.max == Approx(0.2 * share));
        REQUIRE(found.deep.size() == (share > 0.01 ? 1u : 0u));
        if (!found.deep.empty()) CHECK(found.deep.front().share == Approx(share));
    }
}

TEST_CASE("penetration is the depth of the deepest point and the root mean square of all") {
    const std::vector<Body> bodies{static_body(Vector3::Zero()), box_body(1, Vector3::Ones(), {0, 0.4, 0})};
    const std::vector<collision::Collider> colliders{{.body = 0, .shape = collision::Plane{}},
                                                     {.body = 1, .shape = collision::Box{Vector3::Constant(0.5)}}};
    const Penetration found = penetration(bodies, colliders);
    CHECK(found.points == 4);
    CHECK(found.max == Approx(0.1));
    CHECK(found.rms == Approx(0.1));
}

TEST_CASE("the state hash changes with the last bit of any quantity and with nothing else") {
    Random random(10);
    std::vector<Body> bodies{box_body(1, Vector3::Ones(), random.vector(-1, 1), random.rotation())};
    const auto before = state_hash(bodies);
    CHECK(state_hash(bodies) == before);
    bodies[0].force = {1, 2, 3};
    CHECK(state_hash(bodies) == before);
    bodies[0].position.z() = std::nextafter(bodies[0].position.z(), 10.0);
    CHECK(state_hash(bodies) != before);
}

TEST_CASE("the first number that is not finite is found by body and quantity") {
    std::vector<Body> bodies(3, box_body(1, Vector3::Ones(), Vector3::Zero()));
    CHECK(!find_non_finite(bodies));
    bodies[2].linear_momentum.y() = std::numeric_limits<double>::infinity();
    bodies[1].orientation.x() = std::numeric_limits<double>::quiet_NaN();
    REQUIRE(find_non_finite(bodies));
    CHECK(find_non_finite(bodies)->body == 1);
    CHECK(find_non_finite(bodies)->quantity == "orientation");
}
