#include "engine/collision/pairs/collide.h"
#include "tests/catch.h"
#include "tests/dense_algebra.h"
#include "tests/engine/collision/pose.h"

#include <numbers>

using namespace pushfactor::engine;
using namespace pushfactor::engine::collision;
using pushfactor::tests::at;
using pushfactor::tests::rotation_between;

namespace {

const Shape cube = Box{Vector3::Ones()};
const Shape plane = Plane{};

}  // namespace

TEST_CASE("a cube that stands in the ground touches with its four lower corners") {
    Manifold manifold;
    collide(plane, at({5, 0, 5}), cube, at({0, 0.9, 0}), 0.0, manifold);
    REQUIRE(manifold.count == 4);
    CHECK(manifold.normal == Vector3::UnitY());
    for (const ContactPoint& point : manifold.points()) {
        CHECK(point.gap == Approx(-0.1));
        CHECK(point.position.y() == Approx(-0.05));
    }
}

TEST_CASE("the plane as second shape gives the same points and the opposite normal") {
    Manifold one, other;
    const Pose tilted = at({0, 1.2, 0}, Quaternion(Eigen::AngleAxisd(0.3, Vector3(1, 0, 1).normalized())));
    collide(plane, at(Vector3::Zero()), cube, tilted, 0.0, one);
    collide(cube, tilted, plane, at(Vector3::Zero()), 0.0, other);
    REQUIRE(one.count == other.count);
    CHECK(one.normal == -other.normal);
    for (int i = 0; i < one.count; ++i) {
        CHECK(one.points()[static_cast<std::size_t>(i)].gap == other.points()[static_cast<std::size_t>(i)].gap);
    }
}

TEST_CASE("a cube on its corner touches in one point, on its edge in two") {
    const double corner = std::sqrt(3.0);
    const double edge = std::sqrt(2.0);
    Manifold manifold;
    // The body diagonal turned to the vertical.
    const Quaternion on_corner = rotation_between(Vector3::Ones(), Vector3::UnitY());
    collide(plane, at(Vector3::Zero()), cube, at({0, corner - 0.01, 0}, on_corner), 0.0, manifold);
    CHECK(manifold.count == 1);
    const Quaternion on_edge(Eigen::AngleAxisd(std::numbers::pi / 4, Vector3::UnitX()));
    collide(plane, at(Vector3::Zero()), cube, at({0, edge - 0.01, 0}, on_edge), 0.0, manifold);
    CHECK(manifold.count == 2);
}

TEST_CASE("a tilted plane measures gaps along its own normal") {
    const Quaternion slope(Eigen::AngleAxisd(0.5, Vector3::UnitZ()));
    Manifold manifold;
    collide(plane, at(Vector3::Zero(), slope), cube, at(slope * Vector3(0, 0.98, 0), slope), 0.0, manifold);
    REQUIRE(manifold.count == 4);
    CHECK((manifold.normal - slope * Vector3::UnitY()).norm() < 1e-15);
    CHECK(manifold.points()[0].gap == Approx(-0.02));
}

TEST_CASE("two planes make no contact") {
    Manifold manifold;
    collide(plane, at(Vector3::Zero()), plane, at({0, -1, 0}), 0.0, manifold);
    CHECK(manifold.count == 0);
}
