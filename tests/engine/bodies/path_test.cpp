// Paths of moved bodies against closed forms.
#include "tests/catch.h"
#include "tests/engine/world/moved_scene.h"

#include <cmath>

using namespace pushfactor::engine;
using namespace pushfactor::tests;

TEST_CASE("a path is where its closed form says, and its mean velocities lead from place to place") {
    const Place start{{1, 2, 3}, turned(0.3, Vector3::UnitX())};
    const SteadyPath steady(start, {{1, 0, -2}, {0, 30, 0}}, {.from = 1.0, .until = 3.0});
    CHECK((steady.at(0.5).position - start.position).norm() == 0.0);
    CHECK((steady.at(2.0).position - Vector3(2, 2, 1)).norm() < 1e-15);
    CHECK(steady.at(2.0).orientation.angularDistance(turned(30.0) * start.orientation) < 1e-12);
    CHECK((steady.at(9.0).position - Vector3(3, 2, -1)).norm() < 1e-15);
    CHECK(steady.mean(0.5, 1.0).is_none());
    CHECK(steady.mean(0.5, 1.0 + 1e-12).is_none());  // the sum of steps
    CHECK((steady.mean(0.5, 1.5).velocity - Vector3(0.5, 0, -1)).norm() < 1e-14);
    CHECK((steady.mean(1.0, 2.0).angular_velocity - Vector3(0, 30, 0)).norm() < 1e-12);  // many turns a step
    CHECK(steady.mean(3.0 - 1e-12, 4.0).is_none());

    const Oscillation shaker(start, {0, 0.2, 0}, 5.0, 0.7, {.from = 1.0});
    const double height = 2.0 + 0.2 * (std::sin(2 * pi * 5 * 0.13 + 0.7) - std::sin(0.7));
    CHECK(shaker.at(1.13).position.y() == Approx(height).epsilon(1e-12));
    CHECK(shaker.at(1.0).position == start.position);

    const PlaceTable table(start, {{1.0, {{2, 2, 3}, start.orientation}}, {1.5, {{2, 5, 3}, turned(2.0)}}});
    CHECK((table.at(0.5).position - Vector3(1.5, 2, 3)).norm() < 1e-15);
    CHECK(table.at(1.0 + 1e-11).position == Vector3(2, 2, 3));
    CHECK(table.at(1.5).orientation.coeffs() == turned(2.0).coeffs());
    CHECK(table.at(7.0).position == Vector3(2, 5, 3));
    CHECK((table.mean(1.1, 1.2).velocity - Vector3(0, 6, 0)).norm() < 1e-12);
    CHECK((table.mean(0.75, 1.25).velocity - Vector3(0.5, 3, 0)).norm() < 1e-12);
    CHECK(table.mean(1.5, 2.0).is_none());
    const Motion turning = table.mean(1.1, 1.2);
    const Quaternion turn = turned(0.1 * turning.angular_velocity.norm(), turning.angular_velocity.normalized());
    CHECK((turn * table.at(1.1).orientation).angularDistance(table.at(1.2).orientation) < 1e-12);
}
