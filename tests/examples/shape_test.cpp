// A shape, as engine/README.md shows it.
#include "engine/collision/collider.h"
#include "engine/collision/manifold.h"
#include "tests/catch.h"
#include "tests/engine/collision/pose.h"
#include "tests/random.h"

#include <cmath>
#include <numbers>

using namespace pushfactor;
using namespace pushfactor::engine;
using namespace pushfactor::engine::collision;

namespace {

// [example: shape]
// A cylinder with round ends along the body frame's y axis, centred on the body's position.
struct Capsule {
    double radius = 0.25;      // m
    double half_length = 0.5;  // m, from the middle to the centre of a round end
};

// As collide() in collide.h. A point for each end, whose feature is the end: 0 above, 1 below in the body frame.
void collide_capsule_plane(const Capsule& capsule, const Pose& capsule_pose, const Plane&, const Pose& plane_pose,
                           double margin, Manifold& manifold) {
    const Vector3 up = plane_pose.rotation.col(1);
    const Vector3 along = capsule.half_length * capsule_pose.rotation.col(1);
    manifold.normal = -up;
    for (const std::uint32_t end : {0u, 1u}) {
        const Vector3 centre = capsule_pose.position + (end == 0 ? along : -along);
        const double height = up.dot(centre - plane_pose.position);
        const double gap = height - capsule.radius;
        if (gap < margin) manifold.add({centre - 0.5 * (height + capsule.radius) * up, gap, end});
    }
}
// [end]

// The lowest of many points of a capsule's surface above a plane [m].
double lowest_point(const Capsule& capsule, const Pose& pose, const Pose& plane) {
    constexpr int steps = 200;
    double lowest = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= steps; ++i) {
        const double polar = std::numbers::pi * i / steps;
        for (int j = 0; j < 2 * steps; ++j) {
            const double turn = std::numbers::pi * j / steps;
            const Vector3 out(std::sin(polar) * std::cos(turn), std::cos(polar), std::sin(polar) * std::sin(turn));
            const Vector3 end(0, out.y() < 0.0 ? -capsule.half_length : capsule.half_length, 0);
            const Vector3 point = pose.position + pose.rotation * (end + capsule.radius * out);
            lowest = std::min(lowest, plane.rotation.col(1).dot(point - plane.position));
        }
    }
    return lowest;
}

}  // namespace

TEST_CASE("example: the gap of a capsule above a plane is the height of the lowest of its points") {
    tests::Random random(7);
    for (int k = 0; k < 20; ++k) {
        const Capsule capsule{.radius = random.in(0.1, 1.0), .half_length = random.in(0.0, 2.0)};
        const Pose pose = tests::at(random.vector(-3, 3), random.rotation());
        const Pose plane = tests::at(random.vector(-3, 3), random.rotation());
        Manifold manifold;
        collide_capsule_plane(capsule, pose, Plane{}, plane, std::numeric_limits<double>::infinity(), manifold);
        REQUIRE(manifold.count == 2);
        const double gap = std::min(manifold.storage[0].gap, manifold.storage[1].gap);
        const double lowest = lowest_point(capsule, pose, plane);
        CHECK(gap <= lowest + 1e-12);
        CHECK(gap > lowest - 1e-3 * capsule.radius);  // points lie half a step of 0.016 rad apart at most
    }
}

TEST_CASE("example: a capsule that lies in the ground touches with both ends, one that stands with the lower") {
    const Capsule capsule{.radius = 0.3, .half_length = 1.0};
    const Quaternion lying(Eigen::AngleAxisd(std::numbers::pi / 2, Vector3::UnitZ()));
    Manifold manifold;
    collide_capsule_plane(capsule, tests::at({0, 0.2, 0}, lying), Plane{}, tests::at({5, 0, 5}), 0.0, manifold);
    REQUIRE(manifold.count == 2);
    for (const ContactPoint& point : manifold.points()) {
        CHECK(point.gap == Approx(-0.1));
        CHECK(point.position.y() == Approx(-0.05));
        CHECK(std::abs(point.position.x()) == Approx(1.0));
    }
    Manifold standing;
    collide_capsule_plane(capsule, tests::at({0, 1.2, 0}), Plane{}, tests::at({5, 0, 5}), 0.0, standing);
    REQUIRE(standing.count == 1);
    CHECK(standing.storage[0].feature == 1);
    CHECK(standing.storage[0].gap == Approx(-0.1));
}
