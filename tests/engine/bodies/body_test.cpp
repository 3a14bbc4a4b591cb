#include "engine/bodies/body.h"

#include "engine/base/invalid_input.h"
#include "tests/catch.h"

#include <limits>
#include <numbers>

using namespace pushfactor::engine;

TEST_CASE("the inertia of a box is m/12 times the sum of the squares of its other two edges") {
    const Body box = box_body(12.0, {1.0, 2.0, 3.0}, Vector3::Zero());
    CHECK(1.0 / box.inverse_inertia.x() == Approx(13.0));
    CHECK(1.0 / box.inverse_inertia.y() == Approx(10.0));
    CHECK(1.0 / box.inverse_inertia.z() == Approx(5.0));
    CHECK(box.mass() == Approx(12.0));
}

TEST_CASE("a static body has no inverse mass and no velocity whatever its momenta say") {
    Body wall = static_body({1, 2, 3});
    wall.linear_momentum = {4, 5, 6};
    wall.angular_momentum = {7, 8, 9};
    CHECK(wall.is_static());
    CHECK(velocity_at(wall, {10, 10, 10}) == Vector3::Zero());
}

TEST_CASE("a turned box has its inertia turned with it") {
    const Quaternion quarter(Eigen::AngleAxisd(std::numbers::pi / 2, Vector3::UnitZ()));
    const Body box = box_body(12.0, {1.0, 2.0, 3.0}, Vector3::Zero(), quarter);
    const Matrix3 inertia = world_inverse_inertia(box).inverse();
    CHECK(inertia(0, 0) == Approx(10.0));
    CHECK(inertia(1, 1) == Approx(13.0));
    CHECK(inertia(2, 2) == Approx(5.0));
}

TEST_CASE("a mass or an edge that is not finite and above zero is refused by name") {
    for (const double bad :
         {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        CHECK_THROWS_WITH(box_body(bad, Vector3::Ones(), Vector3::Zero()), Catch::Contains("mass_kg"));
        CHECK_THROWS_WITH(box_body(1.0, {1.0, bad, 1.0}, Vector3::Zero()), Catch::Contains("size_m"));
    }
}
