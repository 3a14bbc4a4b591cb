#include "engine/collision/pairs/collide.h"
#include "engine/collision/pairs/pairs.h"
#include "tests/catch.h"
#include "tests/dense_algebra.h"
#include "tests/engine/collision/hulls.h"
#include "tests/engine/collision/kept.h"
#include "tests/engine/collision/pose.h"

#include <algorithm>
#include <limits>
#include <set>

using namespace pushfactor::engine;
using namespace pushfactor::engine::collision;
using pushfactor::tests::at;
using pushfactor::tests::ball_points;
using pushfactor::tests::box_points;
using pushfactor::tests::keep_four;
using pushfactor::tests::Points;
using pushfactor::tests::polyhedron_of;
using pushfactor::tests::Random;
using pushfactor::tests::random_points;
using pushfactor::tests::rotation_between;

namespace {

Manifold collided(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, double margin = 0.0) {
    Manifold manifold;
    collide(a, pose_a, b, pose_b, margin, manifold);
    return manifold;
}

const Hull& hull_of(const Shape& shape) {
    return std::get<Polyhedron>(shape).mesh->hull();
}

std::vector<Vector3> placed(const Hull& hull, const Pose& pose) {
    std::vector<Vector3> all;
    for (const Vector3& vertex : hull.vertices) all.emplace_back(pose.position + pose.rotation * vertex);
    return all;
}

// Gap along `axis` from a to b, by projecting all vertices.
double gap_along(const Vector3& axis, std::span<const Vector3> a, std::span<const Vector3> b) {
    double high = -infinity, low = infinity;
    for (const Vector3& point : a) high = std::max(high, axis.dot(point));
    for (const Vector3& point : b) low = std::min(low, axis.dot(point));
    return low - high;
}

struct Least {
    double gap = -infinity;
    Vector3 normal = Vector3::Zero();
};

// The oracle: all face normals of both and the cross products of all edges with all edges, both ways.
Least brute_force(const Hull& a, const Pose& pose_a, const Hull& b, const Pose& pose_b) {
    const std::vector<Vector3> points_a = placed(a, pose_a), points_b = placed(b, pose_b);
    Least best;
    const auto consider = [&](const Vector3& axis) {
        const double gap = gap_along(axis, points_a, points_b);
        if (gap > best.gap) best = {gap, axis};
    };
    for (const HullFace& face : a.faces) consider(pose_a.rotation * face.normal);
    for (const HullFace& face : b.faces) consider(-(pose_b.rotation * face.normal));
    for (const HullEdge& p : a.edges) {
        for (const HullEdge& q : b.edges) {
            const Vector3 cross = (pose_a.rotation * p.direction).cross(pose_b.rotation * q.direction);
            if (cross.norm() < 1e-3) continue;
            consider(cross.normalized());
            consider(-cross.normalized());
        }
    }
    return best;
}

double deepest(const Manifold& manifold) {
    double gap = infinity;
    for (const ContactPoint& point : manifold.points()) gap = std::min(gap, point.gap);
    return gap;
}

// How far a point is outside a hull [m], at least; negative inside.
double outside(const Vector3& point, const Hull& hull, const Pose& pose) {
    const Vector3 local = pose.rotation.transpose() * (point - pose.position);
    double most = -infinity;
    for (const HullFace& face : hull.faces) most = std::max(most, face.normal.dot(local) - face.offset);
    return most;
}

std::set<std::uint32_t> features(const Manifold& manifold) {
    std::set<std::uint32_t> result;
    for (const ContactPoint& point : manifold.points()) result.insert(point.feature);
    return result;
}

// Depth, normal and points of `pairs` random pairs that overlap.
void compare_with_brute_force(std::uint64_t seed, int pairs) {
    Random random(seed);
    int touching = 0, by_edges = 0;
    while (touching < pairs) {
        const Shape a = polyhedron_of(random_points(random)), b = polyhedron_of(random_points(random));
        const Pose pose_a = at(random.vector(-1, 1), random.rotation());
        const Pose pose_b = at(random.vector(-1, 1), random.rotation());
        const Hull &hull_a = hull_of(a), &hull_b = hull_of(b);
        const double size = std::min(hull_a.size, hull_b.size);
        const Least least = brute_force(hull_a, pose_a, hull_b, pose_b);
        if (std::abs(least.gap) < 1e-6) continue;
        const Manifold manifold = collided(a, pose_a, b, pose_b);
        REQUIRE((manifold.count > 0) == (least.gap < 0.0));
        if (manifold.count == 0) continue;
        ++touching;
        by_edges += manifold.count == 1 ? 1 : 0;
        // Preferred faces: 5e-4 of the size at most twice.
        REQUIRE(manifold.separation == Approx(least.gap).epsilon(0).margin(1e-6 * size));
        const double along = gap_along(manifold.normal, placed(hull_a, pose_a), placed(hull_b, pose_b));
        REQUIRE(along > least.gap - 1.1e-2 * size);
        if (along > least.gap - 1e-9) REQUIRE(deepest(manifold) == Approx(least.gap).epsilon(0).margin(1e-9));
        REQUIRE(deepest(manifold) > along - 1e-9);
        for (const ContactPoint& point : manifold.points()) {
            // Midway between the two surfaces, but for the widened face.
            const Vector3 half = 0.5 * point.gap * manifold.normal;
            REQUIRE(std::abs(outside(point.position - half, hull_a, pose_a)) < 1e-2 * size);
            REQUIRE(std::abs(outside(point.position + half, hull_b, pose_b)) < 1e-2 * size);
        }
        REQUIRE(features(manifold).size() == static_cast<std::size_t>(manifold.count));
    }
    CHECK(by_edges > pairs / 20);
}

}  // namespace

TEST_CASE("depth and normal of polyhedra are the least overlap over all faces and edges by brute force") {
    compare_with_brute_force(1, 2000);
}

TEST_CASE("depth and normal of 100,000 pairs of polyhedra are the least overlap by brute force", "[.]") {
    compare_with_brute_force(2, 100000);
}

TEST_CASE("polyhedra of 240 corners touch exactly when brute force finds no axis between them") {
    Random random(3);
    const Shape ball = polyhedron_of(ball_points(240));
    for (int i = 0; i < 4; ++i) {
        const Pose pose_a = at(Vector3::Zero(), random.rotation());
        const Pose pose_b = at(1.97 * random.vector(-1, 1).normalized(), random.rotation());
        const Least least = brute_force(hull_of(ball), pose_a, hull_of(ball), pose_b);
        const Manifold manifold = collided(ball, pose_a, ball, pose_b, 0.2);
        REQUIRE(manifold.separation == Approx(least.gap).epsilon(0).margin(3e-6));
    }
}

TEST_CASE("the contact of polyhedra turns with the pair, and with the normal turned it is that of b and a") {
    Random random(4);
    int touching = 0;
    while (touching < 500) {
        const Shape a = polyhedron_of(random_points(random)), b = polyhedron_of(random_points(random));
        const Pose pose_a = at(random.vector(-0.5, 0.5), random.rotation());
        const Pose pose_b = at(random.vector(-1, 1), random.rotation());
        const Manifold ab = collided(a, pose_a, b, pose_b), ba = collided(b, pose_b, a, pose_a);
        REQUIRE((ab.count > 0) == (ba.count > 0));
        if (ab.count == 0) continue;
        ++touching;
        const double size = std::min(hull_of(a).size, hull_of(b).size);
        // The preference for the first may choose another axis when two are equally good.
        REQUIRE(deepest(ab) == Approx(deepest(ba)).epsilon(0).margin(2e-3 * size));
        if (ab.normal.dot(ba.normal) < -0.999999 && ab.count == ba.count && ab.count == 1) {
            REQUIRE((ab.points()[0].position - ba.points()[0].position).norm() < 1e-9);
        }
        const Quaternion turn = random.rotation();
        const Vector3 by = random.vector(-2, 2);
        const auto moved = [&](const Pose& pose) {
            return Pose{turn * pose.position + by, turn.toRotationMatrix() * pose.rotation};
        };
        const Manifold turned = collided(a, moved(pose_a), b, moved(pose_b));
        REQUIRE(turned.count == ab.count);
        REQUIRE((turned.normal - turn * ab.normal).norm() < 1e-9);
        for (int k = 0; k < ab.count; ++k) {
            const auto i = static_cast<std::size_t>(k);
            REQUIRE((turned.points()[i].position - (turn * ab.points()[i].position + by)).norm() < 1e-9);
            REQUIRE(turned.points()[i].feature == ab.points()[i].feature);
        }
    }
}

TEST_CASE("a box given as eight points touches boxes, polyhedra, balls and planes as the box does") {
    Random random(5);
    int touching = 0;
    for (int i = 0; i < 4000; ++i) {
        const Vector3 half_a = random.vector(0.2, 1.0), half_b = random.vector(0.2, 1.0);
        const std::array<Shape, 2> a{Box{half_a}, polyhedron_of(box_points(half_a))};
        const std::array<Shape, 2> b{Box{half_b}, polyhedron_of(box_points(half_b))};
        const bool aligned = i % 4 == 0;
        const Pose pose_a = at(random.vector(-0.5, 0.5), aligned ? Quaternion::Identity() : random.rotation());
        Pose pose_b = at(random.vector(-1.5, 1.5), aligned ? Quaternion::Identity() : random.rotation());
        if (i % 8 == 0) pose_b.position = pose_a.position + Vector3(0, half_a.y() + half_b.y() - 0.01, 0);
        const Manifold boxes = collided(a[0], pose_a, b[0], pose_b, 0.01);
        for (const auto& [p, q] : {std::pair{1, 1}, {0, 1}, {1, 0}}) {
            const Manifold other =
                collided(a[static_cast<std::size_t>(p)], pose_a, b[static_cast<std::size_t>(q)], pose_b, 0.01);
            REQUIRE(other.count == boxes.count);
            if (boxes.count == 0) continue;
            ++touching;
            REQUIRE((other.normal - boxes.normal).norm() < 1e-12);
            REQUIRE(other.separation == Approx(boxes.separation).epsilon(0).margin(1e-12));
            if (std::isfinite(boxes.other_gap)) REQUIRE(std::abs(other.other_gap - boxes.other_gap) < 1e-12);
            for (int k = 0; k < boxes.count; ++k) {  // in the same order
                const ContactPoint &here = other.storage[static_cast<std::size_t>(k)],
                                   &there = boxes.storage[static_cast<std::size_t>(k)];
                INFO(i << " pair " << p << q << " point " << k << " of " << boxes.count << " features "
                       << there.feature);
                INFO(here.position.transpose() << " / " << there.position.transpose());
                REQUIRE((here.position - there.position).norm() < 1e-12);
                REQUIRE(std::abs(here.gap - there.gap) < 1e-12);
            }
        }
        const Pose plane = at(random.vector(-1, 1), random.rotation());
        const Manifold on_plane = collided(a[0], pose_a, Plane{}, plane, 0.01);
        const Manifold also = collided(a[1], pose_a, Plane{}, plane, 0.01);
        REQUIRE(also.count == on_plane.count);
        for (int k = 0; k < on_plane.count; ++k) {
            const auto at_k = static_cast<std::size_t>(k);
            REQUIRE((also.points()[at_k].position - on_plane.points()[at_k].position).norm() < 1e-12);
        }
        const Sphere ball{random.in(0.1, 0.8)};
        const Manifold touched = collided(a[0], pose_a, ball, pose_b, 0.01);
        const Manifold touched_too = collided(a[1], pose_a, ball, pose_b, 0.01);
        REQUIRE(touched_too.count == touched.count);
        if (touched.count == 0) continue;
        REQUIRE((touched_too.normal - touched.normal).norm() < 1e-9);
        REQUIRE((touched_too.points()[0].position - touched.points()[0].position).norm() < 1e-9);
    }
    CHECK(touching > 3000);
}

TEST_CASE("a ball touches a polyhedron at the closest of many points of its surface") {
    Random random(6);
    for (int i = 0; i < 300; ++i) {
        const Shape shape = polyhedron_of(random_points(random));
        const Hull& hull = hull_of(shape);
        const Pose pose = at(random.vector(-1, 1), random.rotation()), centre = at(random.vector(-2, 2));
        if (outside(centre.position, hull, pose) < 0.01) continue;
        const Manifold manifold = collided(shape, pose, Sphere{0.5}, centre, infinity);
        REQUIRE(manifold.count == 1);
        const double distance = manifold.points()[0].gap + 0.5;
        const Vector3 surface = centre.position - distance * manifold.normal;
        REQUIRE(std::abs(outside(surface, hull, pose)) < 1e-9);  // on the surface
        // The surface is all on one side of the plane there: no point of it is closer.
        for (const Vector3& vertex : placed(hull, pose)) {
            REQUIRE(manifold.normal.dot(vertex - surface) < 1e-6);
        }
    }
}

TEST_CASE("noise of rounding size changes no feature of polyhedra that lie on each other") {
    Random random(7);
    Points prism;
    for (int k = 0; k < 12; ++k) {
        const double angle = k * std::numbers::pi / 6;
        for (const double y : {-0.5, 0.5}) prism.emplace_back(std::cos(angle), y, std::sin(angle));
    }
    const Shape shape = polyhedron_of(prism);
    REQUIRE(hull_of(shape).faces.size() == 14);
    const Quaternion across = Quaternion(Eigen::AngleAxisd(0.1, Vector3::UnitY()));
    for (const Quaternion& above : {Quaternion::Identity(), across}) {
        const auto touched = [&](const Quaternion& tilt, const Vector3& by) {
            Manifold manifold = collided(shape, at({0, 0, 0}), shape, at(Vector3(0, 0.99, 0) + by, tilt * above));
            CHECK(manifold.count >= 12);
            keep_four(manifold);
            return features(manifold);
        };
        const auto expected = touched(Quaternion::Identity(), Vector3::Zero());
        CHECK(expected.size() == 4);
        for (int i = 0; i < 300; ++i) {
            const Quaternion tilt(Eigen::AngleAxisd(random.in(0, 1e-9), random.vector(-1, 1).normalized()));
            REQUIRE(touched(tilt, random.vector(-1e-9, 1e-9)) == expected);
        }
    }
}

TEST_CASE("what a rounded polyhedron lies on comes before what is farther out and higher") {
    const Shape ball = polyhedron_of(ball_points(240));
    const Hull& hull = hull_of(ball);
    // On its largest face.
    const HullFace* lowest = &hull.faces.front();
    for (const HullFace& face : hull.faces) {
        if (face.count > lowest->count) lowest = &face;
    }
    const Quaternion turn = rotation_between(lowest->normal, -Vector3::UnitY());
    Manifold manifold = collided(ball, at({0, lowest->offset - 1e-4, 0}, turn), Plane{}, at({0, 0, 0}), 0.05);
    CHECK(manifold.count > 4);
    keep_four(manifold);
    REQUIRE(manifold.count == 4);
    const auto on_plane = std::count_if(manifold.points().begin(), manifold.points().end(),
                                        [](const ContactPoint& point) { return point.gap < 0.0; });
    CHECK(on_plane == std::min(lowest->count, 4));
}
