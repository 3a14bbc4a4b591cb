#include "engine/collision/pairs/pairs.h"
#include "tests/catch.h"
#include "tests/engine/collision/pose.h"
#include "tests/random.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

using namespace pushfactor::engine;
using namespace pushfactor::engine::collision;
using pushfactor::tests::at;
using pushfactor::tests::Random;

namespace {

Quaternion turn(double angle, const Vector3& axis) {
    return Quaternion(Eigen::AngleAxisd(angle, axis.normalized()));
}

Manifold collide_boxes(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b, double margin = 0.0) {
    Manifold manifold;
    collide_box_box(a, pose_a, b, pose_b, margin, manifold);
    return manifold;
}

struct Interval {
    double low, high;
};

Interval project(const Box& box, const Pose& pose, const Vector3& axis) {
    Interval interval{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (int corner = 0; corner < 8; ++corner) {
        const Vector3 sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
        const double x = axis.dot(pose.position + pose.rotation * sign.cwiseProduct(box.half_size));
        interval = {std::min(interval.low, x), std::max(interval.high, x)};
    }
    return interval;
}

// The oracle: all 15 axes by projecting all corners.
double brute_force_separation(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b) {
    std::vector<Vector3> axes;
    for (int i = 0; i < 3; ++i) {
        axes.emplace_back(pose_a.rotation.col(i));
        axes.emplace_back(pose_b.rotation.col(i));
        for (int j = 0; j < 3; ++j) {
            const Vector3 cross = pose_a.rotation.col(i).cross(pose_b.rotation.col(j));
            if (cross.norm() > 1e-3) axes.emplace_back(cross.normalized());
        }
    }
    double largest = -std::numeric_limits<double>::infinity();
    for (const Vector3& axis : axes) {
        const Interval p = project(a, pose_a, axis);
        const Interval q = project(b, pose_b, axis);
        largest = std::max(largest, std::max(q.low - p.high, p.low - q.high));
    }
    return largest;
}

double deepest(const Manifold& manifold) {
    double depth = -std::numeric_limits<double>::infinity();
    for (const ContactPoint& point : manifold.points()) depth = std::max(depth, -point.gap);
    return depth;
}

std::multiset<std::uint32_t> features(const Manifold& manifold) {
    std::multiset<std::uint32_t> result;
    for (const ContactPoint& point : manifold.points()) result.insert(point.feature);
    return result;
}

}  // namespace

TEST_CASE("two aligned cubes touch in the four corners, each with the overlap as depth") {
    const Box cube{Vector3::Constant(1.2)};
    const Manifold manifold = collide_boxes(cube, at({0, 1.2, 0}), cube, at({0, 3.5, 0}));
    REQUIRE(manifold.count == 4);
    CHECK(manifold.normal == Vector3::UnitY());
    for (const ContactPoint& point : manifold.points()) {
        CHECK(point.gap == Approx(-0.1));
        CHECK(point.position.y() == Approx(2.35));  // midway between 2.4 and 2.3
        CHECK(std::abs(point.position.x()) == Approx(1.2));
        CHECK(std::abs(point.position.z()) == Approx(1.2));
    }
}

TEST_CASE("a cube turned by 45 degrees on another touches in an octagon") {
    const Box cube{Vector3::Ones()};
    const Manifold manifold =
        collide_boxes(cube, at({0, 0, 0}), cube, at({0, 1.99, 0}, turn(std::numbers::pi / 4, Vector3::UnitY())));
    CHECK(manifold.count == 8);
    const auto named = features(manifold);
    CHECK(std::set<std::uint32_t>(named.begin(), named.end()).size() == 8);  // no two points of one name
}

TEST_CASE("two crossing edges make one point where they cross") {
    // Both boxes stand on an edge; the edges cross at right angles above the origin.
    const Box cube{Vector3::Ones()};
    const double r = std::sqrt(2.0);
    const Pose lower = at({0, -r + 0.05, 0}, turn(std::numbers::pi / 4, Vector3::UnitX()));
    const Pose upper = at({0.3, r - 0.05, 0.2}, turn(std::numbers::pi / 4, Vector3::UnitZ()));
    const Manifold manifold = collide_boxes(cube, lower, cube, upper);
    REQUIRE(manifold.count == 1);
    CHECK(manifold.normal.y() == Approx(1.0));
    CHECK(manifold.points()[0].gap == Approx(-0.1));
    CHECK(manifold.points()[0].position.x() == Approx(0.3));
    CHECK(manifold.points()[0].position.y() == Approx(0.0).margin(1e-12));
    CHECK(manifold.points()[0].position.z() == Approx(0.0).margin(1e-12));
}

TEST_CASE("boxes touch exactly when no axis of the brute-force oracle separates them") {
    Random random(1);
    int touching = 0;
    for (int i = 0; i < 20000; ++i) {
        const Box a{random.vector(0.2, 1.5)};
        const Box b{random.vector(0.2, 1.5)};
        const Pose pose_a = at(random.vector(-1, 1), random.rotation());
        const Pose pose_b = at(random.vector(-2.5, 2.5), random.rotation());
        const double separation = brute_force_separation(a, pose_a, b, pose_b);
        if (std::abs(separation) < 1e-6) continue;
        const Manifold manifold = collide_boxes(a, pose_a, b, pose_b);
        REQUIRE((manifold.count > 0) == (separation < 0.0));
        if (manifold.count == 0) continue;
        ++touching;
        // The chosen axis is the best one up to the preference, at most twice 5e-4 of the size.
        REQUIRE(manifold.normal.norm() == Approx(1.0));
        REQUIRE(deepest(manifold) == Approx(-separation).margin(2e-3));
        // Moved apart along the normal by the depth (and the preference), they no longer touch.
        const Pose apart{pose_b.position + manifold.normal * (deepest(manifold) + 1e-9), pose_b.rotation};
        REQUIRE(collide_boxes(a, pose_a, b, apart).count == 0);
    }
    CHECK(touching > 3000);
}

TEST_CASE("the contact of a and b is the contact of b and a with the normal turned") {
    Random random(2);
    for (int i = 0; i < 2000; ++i) {
        const Box a{random.vector(0.3, 1.0)};
        const Box b{random.vector(0.3, 1.0)};
        const Pose pose_a = at(random.vector(-0.5, 0.5), random.rotation());
        const Pose pose_b = at(random.vector(-1.0, 1.0), random.rotation());
        const Manifold ab = collide_boxes(a, pose_a, b, pose_b);
        const Manifold ba = collide_boxes(b, pose_b, a, pose_a);
        REQUIRE((ab.count > 0) == (ba.count > 0));
        // The preference for the first box may choose another axis when two are equally good.
        if (ab.count > 0) REQUIRE(deepest(ab) == Approx(deepest(ba)).margin(1e-3));
    }
}

TEST_CASE("noise of rounding size changes no feature of exactly aligned cubes") {
    Random random(3);
    const Box cube{Vector3::Constant(1.2)};
    const auto expected = features(collide_boxes(cube, at({0, 1.2, 0}), cube, at({0, 3.59, 0})));
    REQUIRE(expected.size() == 4);
    for (int i = 0; i < 1000; ++i) {
        const Quaternion tilt = turn(random.in(0, 1e-9), random.vector(-1, 1));
        const Pose upper = at(Vector3(0, 3.59, 0) + random.vector(-1e-9, 1e-9), tilt);
        REQUIRE(features(collide_boxes(cube, at({0, 1.2, 0}), cube, upper)) == expected);
    }
}

TEST_CASE("noise of rounding size turns no normal where two ways out are equally far") {
    Random random(5);
    const Box cube{Vector3::Constant(0.3)};
    const Vector3 beside(0.6, 0, 0.6);  // edge to edge
    const Vector3 expected = collide_boxes(cube, at(Vector3::Zero()), cube, at(beside), 0.01).normal;
    for (int i = 0; i < 1000; ++i) {
        const Quaternion tilt = turn(random.in(0, 1e-9), random.vector(-1, 1));
        const Pose other = at(beside + random.vector(-1e-9, 1e-9), tilt);
        REQUIRE((collide_boxes(cube, at(Vector3::Zero()), cube, other, 0.01).normal - expected).norm() < 1e-8);
    }
}

// Whether the normal belongs to two edges.
bool is_of_edges(const Manifold& manifold, const Quaternion& of_a, const Quaternion& of_b) {
    const auto along = [&](const Quaternion& turned) {
        return (turned.conjugate() * manifold.normal).cwiseAbs().maxCoeff();
    };
    return std::max(along(of_a), along(of_b)) < 1.0 - 1e-9;
}

TEST_CASE("noise of rounding size changes no feature of crossing edges") {
    Random random(17);
    int crossings = 0;
    for (int i = 0; i < 400; ++i) {
        const Box a{Vector3(0.5, 0.8, 0.3)}, b{Vector3::Constant(0.6)};
        const Quaternion of_a = random.rotation(), of_b = random.rotation();
        const Vector3 offset = random.vector(-0.8, 0.8);
        const Manifold before = collide_boxes(a, at(Vector3::Zero(), of_a), b, at(offset, of_b));
        const Quaternion nudged = turn(1e-12, random.vector(-1, 1)) * of_b;
        const Manifold after = collide_boxes(a, at(Vector3::Zero(), of_a), b, at(offset, nudged));
        if (before.count == 0 || !is_of_edges(before, of_a, of_b)) continue;
        ++crossings;
        REQUIRE(features(after) == features(before));
    }
    CHECK(crossings > 50);
}

TEST_CASE("rods that lie across each other touch in the same points however they roll") {
    const Box rod{Vector3(0.75, 0.03, 0.03)};
    Random random(18);
    std::array<int, 2> of_kind{};
    const auto corners =
        features(collide_boxes(rod, at(Vector3::Zero()), rod, at({0.1, 0.059, 0.1}, turn(1.3, Vector3::UnitY()))));
    REQUIRE(corners.size() == 4);
    for (int i = 0; i < 300; ++i) {
        const Quaternion of_a = turn(random.in(-0.01, 0.01), Vector3::UnitX());
        const double roll =
            i % 2 == 0 ? 0.0 : random.in(-0.01, 0.01);  // without it the normal is that of a face of b
        const Quaternion of_b = turn(1.3, Vector3::UnitY()) * turn(roll, Vector3::UnitX());
        const Manifold manifold =
            collide_boxes(rod, at(Vector3::Zero(), of_a), rod, at({0.1, 0.059, 0.1}, of_b), 0.01);
        REQUIRE(features(manifold) == corners);
        ++of_kind[is_of_edges(manifold, of_a, of_b) ? 1 : 0];
        // Each is as far from the other rod as it lies beside or in it along the normal.
        for (const ContactPoint& point : manifold.points()) {
            for (const double side : {-0.5, 0.5}) {
                const Vector3 on = point.position + side * point.gap * manifold.normal;
                const Vector3 local = side < 0.0 ? Vector3(of_a.conjugate() * on)
                                                 : Vector3(of_b.conjugate() * (on - Vector3(0.1, 0.059, 0.1)));
                REQUIRE(std::abs(std::abs(local.y()) - 0.03) < 1e-12);
            }
        }
    }
    CHECK(of_kind[0] > 20);
    CHECK(of_kind[1] > 20);
}

TEST_CASE("points that are apart by less than the margin are found, with their gap") {
    const Box cube{Vector3::Ones()};
    CHECK(collide_boxes(cube, at({0, 0, 0}), cube, at({0, 2.01, 0})).count == 0);
    const Manifold near = collide_boxes(cube, at({0, 0, 0}), cube, at({0, 2.01, 0}), 0.02);
    REQUIRE(near.count == 4);
    CHECK(near.points()[0].gap == Approx(0.01));
    CHECK(collide_boxes(cube, at({0, 0, 0}), cube, at({0, 2.03, 0}), 0.02).count == 0);
}

TEST_CASE("cubes with the same centre have a defined normal and finite points") {
    const Box cube{Vector3::Ones()};
    const Manifold manifold = collide_boxes(cube, at({1, 2, 3}), cube, at({1, 2, 3}));
    REQUIRE(manifold.count == 4);
    CHECK(manifold.normal.norm() == Approx(1.0));
    for (const ContactPoint& point : manifold.points()) {
        CHECK(point.position.allFinite());
        CHECK(point.gap == Approx(-2.0));
    }
}
