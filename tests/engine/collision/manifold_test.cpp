#include "engine/collision/manifold.h"

#include "engine/collision/pairs/pairs.h"
#include "tests/catch.h"
#include "tests/engine/collision/kept.h"
#include "tests/random.h"

#include <algorithm>
#include <cmath>

using namespace pushfactor::engine;
using namespace pushfactor::engine::collision;
using pushfactor::tests::keep_four;
using pushfactor::tests::Random;

namespace {

Manifold on_top(double turn, double tilt) {
    const Box cube{Vector3::Ones()};
    const Quaternion rotation = Quaternion(Eigen::AngleAxisd(tilt, Vector3::UnitX())) *
                                Quaternion(Eigen::AngleAxisd(turn, Vector3::UnitY()));
    Manifold manifold;
    collide_box_box(cube, {Vector3::Zero(), Matrix3::Identity()}, cube,
                    {Vector3(0, 1.95, 0), rotation.toRotationMatrix()}, 0.0, manifold);
    return manifold;
}

double area(const Manifold& manifold) {
    double twice = 0.0;
    const auto points = manifold.points();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vector3& p = points[i].position;
        const Vector3& q = points[(i + 1) % points.size()].position;
        twice += p.z() * q.x() - p.x() * q.z();
    }
    return 0.5 * std::abs(twice);
}

}  // namespace

TEST_CASE("a reduced octagon keeps four points, most of its area and its deepest point nearly") {
    Random random(4);
    int octagons = 0;
    for (int i = 0; i < 1000; ++i) {
        const Manifold full = on_top(random.in(-0.7, 0.7), random.in(-0.01, 0.01));
        if (full.count <= 4) continue;
        ++octagons;
        Manifold reduced = full;
        keep_four(reduced);
        REQUIRE(reduced.count == 4);
        REQUIRE(area(reduced) > 0.6 * area(full));
        const auto depth = [](const Manifold& m) {
            const auto points = m.points();
            return std::max_element(points.begin(), points.end(),
                                    [](const auto& p, const auto& q) { return p.gap > q.gap; })
                ->gap;
        };
        REQUIRE(depth(reduced) - depth(full) < 0.01);
    }
    CHECK(octagons > 500);
}

TEST_CASE("rounding noise does not change which points are kept") {
    Manifold first = on_top(0.02, 0.0);
    REQUIRE(first.count == 8);
    keep_four(first);
    Random random(5);
    for (int i = 0; i < 200; ++i) {
        Manifold again = on_top(0.02 + random.in(-1e-10, 1e-10), random.in(-1e-10, 1e-10));
        keep_four(again);
        REQUIRE(again.count == first.count);
        for (std::size_t p = 0; p < 4; ++p) REQUIRE(again.points()[p].feature == first.points()[p].feature);
    }
}

TEST_CASE("a fixed tangent is a unit vector across the normal that turns with the reference") {
    Random random(6);
    for (int i = 0; i < 1000; ++i) {
        const Vector3 normal = random.rotation() * Vector3::UnitX();
        const Matrix3 turn = random.rotation().toRotationMatrix();
        const Vector3 tangent = tangent_fixed_in(Matrix3::Identity(), normal);
        REQUIRE(tangent.norm() == Approx(1.0));
        REQUIRE(tangent.dot(normal) == Approx(0.0).margin(1e-14));
        if (std::abs(std::abs(normal.x()) - 0.8) < 1e-9) continue;
        REQUIRE((tangent_fixed_in(turn, turn * normal) - turn * tangent).norm() < 1e-13);
    }
}
