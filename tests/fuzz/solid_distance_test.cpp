// The distances by which meetings are judged, proved pair by pair.
#include "tests/fuzz/solid_distance.h"

#include "engine/base/invalid_input.h"
#include "tests/catch.h"
#include "tests/random.h"

#include <cmath>

using namespace pushfactor;
using namespace pushfactor::tests;
using demos::BodyDescription;
using engine::Quaternion;
using engine::Vector3;

namespace {

// A box, a ball or a polyhedron of about a metre.
BodyDescription random_piece(Random& random) {
    BodyDescription body{.name = "piece", .mass = 1.0};
    const double which = random.in(0, 3);
    if (which < 1.0) {
        body.shape = demos::BoxShape{random.vector(0.05, 1.0)};
    } else if (which < 1.5) {
        body.shape = demos::SphereShape{random.in(0.05, 0.5)};
    } else {
        std::vector<Vector3> points(static_cast<std::size_t>(random.in(5, 16)));
        for (Vector3& point : points) point = random.vector(-0.5, 0.5);
        give_polyhedron(body, demos::make_polyhedron(points));
    }
    return body;
}

// m, how far the point is outside of the solid without its radius; at most 0 inside.
double outside(const PlacedSolid& solid, const Vector3& point) {
    if (solid.normals.empty()) return (point - solid.position).norm();
    double most = -engine::infinity;
    for (const Vector3& normal : solid.normals) {
        double face = -engine::infinity;
        for (const Vector3& corner : solid.points) face = std::max(face, normal.dot(corner));
        most = std::max(most, normal.dot(point) - face);
    }
    return most;
}

// The largest gap that a search in random directions, and near the best of them, finds.
double largest_gap(const PlacedSolid& a, const PlacedSolid& b, Random& random) {
    double best = -engine::infinity;
    Vector3 at = Vector3::UnitX();
    const auto offer = [&](const Vector3& direction) {
        const double gap = gap_along(a, b, direction.normalized());
        if (gap <= best) return false;
        best = gap;
        at = direction.normalized();
        return true;
    };
    for (int i = 0; i < 3000; ++i) offer(random.rotation() * Vector3::UnitX());
    for (double width = 0.1; width > 1e-9;) {
        bool any = false;
        for (int i = 0; i < 20; ++i) any = offer(at + random.vector(-width, width)) || any;
        if (!any) width *= 0.5;
    }
    return best;
}

}  // namespace

TEST_CASE("the distance of two solids is that of two of their points, and the gap along its normal") {
    Random random(1);
    int apart = 0;
    for (int i = 0; i < 2000; ++i) {
        const Solid one = solid_of(random_piece(random)), other = solid_of(random_piece(random));
        const PlacedSolid a(one, random.vector(-0.5, 0.5), random.rotation());
        const PlacedSolid b(other, random.vector(-1.5, 1.5), random.rotation());
        const Closeness found = closeness(a, b);
        // A gap along any direction is a lower bound on the distance of all points, and two points an upper one.
        CHECK(std::abs(found.normal.norm() - 1.0) < 1e-12);
        if (found.distance > -one.radius - other.radius) {
            ++apart;
            const auto [on_a, on_b] = closest_points(a, b);
            CHECK(outside(a, on_a) < 1e-12);
            CHECK(outside(b, on_b) < 1e-12);
            CHECK(std::abs((on_b - on_a).norm() - one.radius - other.radius - found.distance) < 1e-12);
        }
        CHECK(std::abs(gap_along(a, b, found.normal) - found.distance) < 1e-12);
    }
    CHECK(apart > 1000);
}

TEST_CASE("no direction has a larger gap than the one that is found for solids that overlap") {
    Random random(2);
    int deep = 0;
    while (deep < 100) {
        const Solid one = solid_of(random_piece(random)), other = solid_of(random_piece(random));
        const PlacedSolid a(one, Vector3::Zero(), random.rotation());
        const PlacedSolid b(other, random.vector(-0.5, 0.5), random.rotation());
        const double distance = closeness(a, b).distance;
        if (distance > 0.0) continue;
        ++deep;
        CHECK(largest_gap(a, b, random) <= distance + 1e-12);
    }
}

TEST_CASE("distances of cubes and balls are those of closed forms") {
    const Solid cube = solid_of({.name = "cube", .shape = demos::BoxShape{{1, 1, 1}}});
    const Solid ball = solid_of({.name = "ball", .shape = demos::SphereShape{0.25}});
    const Quaternion none = Quaternion::Identity();
    const Quaternion edge_up(Eigen::AngleAxisd(0.25 * M_PI, Vector3::UnitZ()));
    const PlacedSolid a(cube, Vector3::Zero(), none);
    const auto to = [&](const Solid& solid, const Vector3& position, const Quaternion& orientation) {
        return closeness(a, PlacedSolid(solid, position, orientation));
    };
    CHECK(cube.size == Approx(1.0).margin(1e-12));
    CHECK(cube.edges.size() == 12);
    CHECK(cube.faces.size() == 6);
    CHECK(to(cube, {1.2, 0.3, 0.1}, none).distance == Approx(0.2).margin(1e-14));
    CHECK(to(cube, {1.3, 1.4, 0}, none).distance == Approx(0.5).margin(1e-14));
    CHECK(to(cube, {1.3, 1.4, 2.2}, none).distance == Approx(std::sqrt(1.69)).margin(1e-14));
    CHECK(to(cube, {0.9, 0.3, 0}, none).distance == Approx(-0.1).margin(1e-14));
    CHECK(to(cube, {1.5, 0.2, 0}, edge_up).distance == Approx(1.0 - std::sqrt(0.5)).margin(1e-14));
    CHECK(to(ball, {0, 0.8, 0}, none).distance == Approx(0.05).margin(1e-14));
    CHECK(to(ball, {0, 0.4, 0}, none).distance == Approx(-0.35).margin(1e-14));
    CHECK(to(ball, {0.8, 0.9, 0}, none).distance == Approx(0.25).margin(1e-14));
    const Closeness balls = closeness(PlacedSolid(ball, {1, 1, 1}, none), PlacedSolid(ball, {1, 1.4, 1.3}, none));
    CHECK(balls.distance == Approx(0.0).margin(1e-14));
    CHECK((balls.normal - Vector3(0, 0.8, 0.6)).norm() < 1e-14);
}
