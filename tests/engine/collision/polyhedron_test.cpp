// Polyhedra: hull, mesh and mass properties.
#include "engine/collision/polyhedron.h"

#include "demos/scenes/convex_hull.h"
#include "engine/base/invalid_input.h"
#include "engine/bodies/solid.h"
#include "tests/catch.h"
#include "tests/engine/collision/hulls.h"

#include <limits>

using namespace pushfactor;
using namespace pushfactor::engine;
using namespace pushfactor::engine::collision;
using tests::Points;
using tests::Random;

namespace {

// Mass properties by another way: signed tetrahedra from a point far outside, each the image of the unit
// tetrahedron, whose integrals of x and x x^T are 1/24 and (1 + [i == j]) / 120.
Solid oracle(const Hull& hull) {
    using Wide = long double;
    using WideVector = Eigen::Matrix<Wide, 3, 1>;
    using WideMatrix = Eigen::Matrix<Wide, 3, 3>;
    const WideVector apex = (hull.vertex(0) * 1.5).cast<Wide>();
    const WideMatrix unit = (WideMatrix::Ones() + WideMatrix::Identity()) / 120;
    Wide volume = 0;
    WideVector moment = WideVector::Zero();
    WideMatrix second = WideMatrix::Zero();
    for (const HullFace& face : hull.faces) {
        const auto corners = hull.corners_of(face);
        for (std::size_t i = 2; i < corners.size(); ++i) {
            WideMatrix edges;
            int column = 0;
            for (const std::size_t k : {std::size_t{0}, i - 1, i}) {
                edges.col(column++) = hull.vertex(corners[k].vertex).cast<Wide>() - apex;
            }
            const Wide scale = edges.determinant();
            volume += scale / 6;
            moment += scale / 24 * edges.rowwise().sum();
            second += scale * edges * unit * edges.transpose();
        }
    }
    Solid solid;
    const WideVector centre = moment / volume;
    const WideMatrix about_centre = second / volume - centre * centre.transpose();
    solid.volume = static_cast<double>(volume);
    solid.centre = (apex + centre).cast<double>();
    solid.inertia = (about_centre.trace() * WideMatrix::Identity() - about_centre).cast<double>();
    return solid;
}

std::string refusal(const Points& points) {
    try {
        demos::convex_hull(points);
    } catch (const InvalidInput& refused) {
        return refused.what();
    }
    return "";
}

Points moved(Points points, const Quaternion& turn, const Vector3& by) {
    for (Vector3& point : points) point = turn * point + by;
    return points;
}

}  // namespace

TEST_CASE("mass properties of the five Platonic solids are their closed forms to 1e-12, wherever the points are") {
    Random random(1);
    for (const tests::Platonic& solid : tests::platonic_solids()) {
        INFO(solid.name);
        for (int i = 0; i < 10; ++i) {
            const Vector3 by = i == 0 ? Vector3::Zero() : random.vector(-3, 3);
            const Quaternion turn = i == 0 ? Quaternion::Identity() : random.rotation();
            const demos::FramedPolyhedron made = demos::make_polyhedron(moved(solid.points, turn, by));
            const double edge = solid.edge;
            CHECK(made.shape.mesh->hull().faces.size() == solid.faces);
            CHECK(made.shape.points().size() == solid.points.size());
            CHECK(made.shape.volume / (solid.volume * edge * edge * edge) == Approx(1).epsilon(0).margin(1e-12));
            CHECK((made.shape.moments / (solid.moment * edge * edge) - Vector3::Ones()).norm() < 1e-12);
            CHECK((made.centre - by).norm() < 1e-12);
        }
    }
}

TEST_CASE("mass properties of random hulls are those of signed tetrahedra in wider numbers") {
    Random random(2);
    for (int i = 0; i < 1000; ++i) {
        const demos::FramedPolyhedron made = demos::make_polyhedron(tests::random_points(random));
        const Solid exact = oracle(made.shape.mesh->hull());
        REQUIRE(made.shape.volume == Approx(exact.volume).epsilon(1e-12));
        REQUIRE(exact.centre.norm() < 1e-13);
        const Matrix3 moments = made.shape.moments.asDiagonal();
        REQUIRE((moments - exact.inertia).norm() < 1e-12 * exact.inertia.trace());
    }
}

TEST_CASE("a hull holds all points, its faces are convex, and of its own points it is itself bit for bit") {
    Random random(3);
    for (int i = 0; i < 500; ++i) {
        const Points points = i % 50 == 0 ? tests::ball_points(240) : tests::random_points(random, 60);
        const demos::FramedPolyhedron made = demos::make_polyhedron(points);
        const Hull& hull = made.shape.mesh->hull();
        for (const Vector3& point : points) {
            const Vector3 inside = made.to_body(point);
            for (const HullFace& face : hull.faces) REQUIRE(face.normal.dot(inside) < face.offset + 2e-5);
        }
        const demos::FramedPolyhedron again = demos::make_polyhedron(made.shape.points());
        REQUIRE(again.centre == Vector3::Zero());
        REQUIRE(again.axes.coeffs() == Quaternion::Identity().coeffs());
        REQUIRE(again.shape.moments == made.shape.moments);
        REQUIRE(again.shape.volume == made.shape.volume);
        REQUIRE(std::equal(again.shape.points().begin(), again.shape.points().end(), made.shape.points().begin(),
                           made.shape.points().end()));
    }
}

TEST_CASE(
    "faces in one plane are one face, also where the numbers have five digits, and corners in them are dropped") {
    Points points = tests::box_points({0.5, 1, 2});
    points.emplace_back(0.5, 0.2, 0.3);  // in a face
    points.emplace_back(0.5, 1, 0.7);    // in an edge
    points.emplace_back(0.1, 0.2, 0.3);  // inside
    Random random(4);
    for (int i = 0; i < 100; ++i) {
        Points rounded = moved(points, random.rotation(), random.vector(-1, 1));
        for (Vector3& point : rounded) {
            for (double& number : point) number = std::round(number * 1e5) / 1e5;
        }
        const demos::ConvexHull hull = demos::convex_hull(rounded);
        REQUIRE(hull.points.size() == 8);
        REQUIRE(hull.faces.size() == 6);
    }
}

TEST_CASE("points without a volume are refused by name, and so are too few and too many") {
    CHECK(refusal({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}) == "polyhedron of 3 points: must be of 4 points or more");
    CHECK(refusal(Points(5, Vector3(1, 2, 3))) ==
          "polyhedron of points in one place: must be of points with a volume");
    Points line, plane;
    for (int i = 0; i < 6; ++i) {
        line.emplace_back(i, 2 * i, -i);
        plane.emplace_back(i, i * i, 2 * i + 3 * i * i);
    }
    CHECK(refusal(line) == "polyhedron of points on a line: must be of points with a volume");
    CHECK(refusal(plane) == "polyhedron of points in a plane: must be of points with a volume");
    Points infinite = tests::box_points({1, 1, 1});
    infinite[3].y() = std::numeric_limits<double>::infinity();
    CHECK(refusal(infinite) == "polyhedron of points that are not finite: must be of finite points");
    CHECK(refusal(tests::ball_points(300)) == "polyhedron of 300 corners: must be of at most 256 corners");
    CHECK(refusal(tests::ball_points(256)) == "");
}

TEST_CASE("a mesh that is no convex surface is refused") {
    const Points tetrahedron{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    const std::vector<std::vector<int>> faces{{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
    CHECK_NOTHROW(PolyhedronMesh(tetrahedron, faces));
    CHECK_THROWS_AS(PolyhedronMesh(tetrahedron, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}}), InvalidInput);
    CHECK_THROWS_AS(PolyhedronMesh(tetrahedron, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}), InvalidInput);
    CHECK_THROWS_AS(PolyhedronMesh(tetrahedron, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 2, 3}}), InvalidInput);
    CHECK_THROWS_AS(PolyhedronMesh(tetrahedron, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 4}}), InvalidInput);
    CHECK_THROWS_AS(PolyhedronMesh(moved(tetrahedron, Quaternion::Identity(), {5, 0, 0}), faces), InvalidInput);
}
