#include "engine/collision/pairs/collide.h"
#include "engine/collision/pairs/pairs.h"
#include "tests/catch.h"
#include "tests/engine/collision/pose.h"
#include "tests/random.h"

#include <cmath>

using namespace pushfactor::engine;
using namespace pushfactor::engine::collision;
using pushfactor::tests::at;
using pushfactor::tests::Random;

namespace {

Manifold touch(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, double margin = 0.0) {
    Manifold manifold;
    collide(a, pose_a, b, pose_b, margin, manifold);
    return manifold;
}

}  // namespace

TEST_CASE("two spheres touch in one point midway between their surfaces") {
    const Manifold m = touch(Sphere{1.0}, at({0, 0, 0}), Sphere{2.0}, at({0, 0, 2.9}));
    REQUIRE(m.count == 1);
    CHECK(m.normal == Vector3::UnitZ());
    CHECK(m.points()[0].gap == Approx(-0.1));
    CHECK(m.points()[0].position.z() == Approx(0.95));
    CHECK(touch(Sphere{1.0}, at({0, 0, 0}), Sphere{2.0}, at({0, 0, 3.05})).count == 0);
    CHECK(touch(Sphere{1.0}, at({0, 0, 0}), Sphere{2.0}, at({0, 0, 3.05}), 0.1).count == 1);
}

TEST_CASE("spheres with one centre are pushed apart along the vertical") {
    const Manifold m = touch(Sphere{1.0}, at({3, 4, 5}), Sphere{1.0}, at({3, 4, 5}));
    REQUIRE(m.count == 1);
    CHECK(m.normal == Vector3::UnitY());
    CHECK(m.points()[0].gap == Approx(-2.0));
}

TEST_CASE("a sphere on a tilted plane touches below its centre, along the plane's normal") {
    const Quaternion tilt(Eigen::AngleAxisd(0.6, Vector3::UnitX()));
    const Vector3 up = tilt * Vector3::UnitY();
    const Manifold m = touch(Plane{}, at({1, 0, 0}, tilt), Sphere{0.5}, at(Vector3(1, 0, 0) + 0.48 * up, tilt));
    REQUIRE(m.count == 1);
    CHECK((m.normal - up).norm() < 1e-15);
    CHECK(m.points()[0].gap == Approx(-0.02));
}

TEST_CASE("a sphere touches the nearest point of a box, found by a brute-force search of its surface") {
    Random random(12);
    int touching = 0;
    for (int i = 0; i < 300; ++i) {
        const Box box{random.vector(0.3, 1.0)};
        const Pose pose = at(random.vector(-1, 1), random.rotation());
        const Sphere sphere{random.in(0.2, 1.0)};
        const Vector3 centre = random.vector(-2, 2);
        // All points of a fine grid over the box; the nearest to the centre.
        double nearest = 1e9;
        const int n = 24;
        for (int x = 0; x <= n; ++x) {
            for (int y = 0; y <= n; ++y) {
                for (int z = 0; z <= n; ++z) {
                    const Vector3 share(2.0 * x / n - 1, 2.0 * y / n - 1, 2.0 * z / n - 1);
                    const Vector3 point = pose.position + pose.rotation * share.cwiseProduct(box.half_size);
                    nearest = std::min(nearest, (point - centre).norm());
                }
            }
        }
        if (nearest < 0.1) continue;  // the centre is inside or nearly
        const Manifold m = touch(box, pose, sphere, at(centre));
        if (nearest < sphere.radius - 0.1) REQUIRE(m.count == 1);
        if (nearest > sphere.radius) REQUIRE(m.count == 0);
        if (m.count == 0) continue;
        ++touching;
        REQUIRE(m.normal.norm() == Approx(1.0));
        REQUIRE(m.points()[0].gap + sphere.radius == Approx(nearest).margin(0.1));
    }
    CHECK(touching > 30);
}

TEST_CASE("a sphere that lies where four boxes meet touches all of their faces, in spite of roundings") {
    Random random(7);
    const Box box{Vector3::Constant(0.5)};
    const Sphere sphere{0.4};
    for (int i = 0; i < 100; ++i) {
        const Pose on_top = at(Vector3(0.5, 0.9, 0.5) + random.vector(-1e-9, 1e-9));
        const Manifold m = touch(box, at(Vector3::Zero()), sphere, on_top, 0.01);
        REQUIRE(m.count == 1);
        CHECK((m.normal - Vector3::UnitY()).norm() < 1e-14);
        CHECK(std::isinf(m.other_gap));
    }
    // Farther to the side the edge's normal leans.
    const Manifold m = touch(box, at(Vector3::Zero()), sphere, at({0.5 + 1e-5, 0.9, 0.5}), 0.01);
    CHECK(m.normal.x() == Approx(1e-5 / 0.4).epsilon(1e-6));
}

TEST_CASE("a centre inside a box goes out through the nearest face, and from the middle there is an answer") {
    const Box box{{1.0, 2.0, 3.0}};
    const Manifold near = touch(box, at(Vector3::Zero()), Sphere{0.5}, at({-0.8, 0, 0}));
    REQUIRE(near.count == 1);
    CHECK(near.normal == -Vector3::UnitX());
    CHECK(near.points()[0].gap == Approx(-0.7));
    const Manifold middle = touch(Box{Vector3::Ones()}, at(Vector3::Zero()), Sphere{0.5}, at(Vector3::Zero()));
    REQUIRE(middle.count == 1);
    CHECK(middle.normal == Vector3::UnitY());
    CHECK(middle.points()[0].gap == Approx(-1.5));
}

TEST_CASE("the pair the other way round has the same gap and the opposite normal") {
    Random random(13);
    const std::array<Shape, 3> shapes{Shape(Box{{0.5, 0.6, 0.7}}), Shape(Sphere{0.6}), Shape(Plane{})};
    for (int i = 0; i < 200; ++i) {
        const Pose pose_a = at(random.vector(-0.5, 0.5), random.rotation());
        const Pose pose_b = at(random.vector(-0.5, 0.5), random.rotation());
        for (const Shape& other : {shapes[0], shapes[2]}) {
            const Manifold one = touch(shapes[1], pose_a, other, pose_b, 0.1);
            const Manifold two = touch(other, pose_b, shapes[1], pose_a, 0.1);
            REQUIRE(one.count == two.count);
            if (one.count == 0) continue;
            REQUIRE(one.normal == -two.normal);
            REQUIRE(one.points()[0].gap == two.points()[0].gap);
        }
    }
}
