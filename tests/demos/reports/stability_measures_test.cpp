// The measures of the stability report on known motions.
#include "demos/reports/stability/stability.h"
#include "tests/catch.h"

#include <cmath>
#include <functional>
#include <numbers>

using namespace pushfactor::demos::reports::stability;

namespace {

using pushfactor::demos::SceneDescription;
using pushfactor::engine::Quaternion;
using pushfactor::engine::Vector3;

struct Pose {
    Vector3 x, v;
    Vector3 w = Vector3::Zero();
    Quaternion orientation = Quaternion::Identity();
};

// The state of a body at a time [s].
using Motion = std::function<Pose(double time)>;

// The trajectory of bodies with these motions: `moments` states at intervals of `dt` [s].
Evidence moved(const SceneDescription& scene, const std::vector<Motion>& motions, int moments, double dt) {
    Evidence evidence{.scene = &scene};
    Columns& columns = evidence.outputs["trajectory"];
    const auto put = [&columns](const char* x, const char* y, const char* z, const Vector3& value) {
        columns[x].push_back(value.x());
        columns[y].push_back(value.y());
        columns[z].push_back(value.z());
    };
    for (int i = 0; i < moments; ++i) {
        for (const Motion& motion : motions) {
            const Pose pose = motion(dt * i);
            columns["time_s"].push_back(dt * i);
            put("x_m", "y_m", "z_m", pose.x);
            put("vx_m_per_s", "vy_m_per_s", "vz_m_per_s", pose.v);
            put("wx_rad_per_s", "wy_rad_per_s", "wz_rad_per_s", pose.w);
            put("qx", "qy", "qz", pose.orientation.vec());
            columns["qw"].push_back(pose.orientation.w());
        }
    }
    return evidence;
}

SceneDescription balls(int count) {
    SceneDescription scene = bouncing_ball();
    for (int i = 1; i < count; ++i) scene.bodies.push_back(scene.bodies.back());
    return scene;
}

double only(const std::string& measure, const Evidence& evidence) {
    const std::vector<double> values = take(measure, evidence);
    REQUIRE(values.size() == 1);
    return values.front();
}

}  // namespace

TEST_CASE("measures of a thrown ball follow its parabola") {
    // By the recurrence of the engine: it starts at 1 m and rises at 10 m/s, under gravity 10 m/s^2.
    const Motion thrown = [](double time) {
        const double steps = std::round(time / 0.1);
        return Pose{.x = {0, 1.0 + 0.1 * (10.0 * steps - 0.5 * steps * (steps + 1.0)), 0},
                    .v = {0, 10.0 - steps, 0}};
    };
    const auto scene = bouncing_ball();
    const Evidence evidence = moved(scene, {thrown}, 30, 0.1);
    CHECK(only("relative_energy_change", evidence) < 1e-12);
    CHECK(only("acceleration_m_per_s2", evidence) == Approx(10.0));
    CHECK(only("deflection_m_per_s", evidence) == Approx(29.0));
    CHECK(only("depth_m", evidence) == Approx(29 * 30 / 2 * 0.1 - 30.0).margin(1e-9));
    CHECK(take("spread_of_5_apexes_m", evidence).empty());  // it does not bounce
}

TEST_CASE("slides are measured level, to the end and at most, and beside the first direction") {
    // Along 3/4/5 for 2 s, out to 10 m and half of it back, on an arch that goes 0.3 m sideways and up.
    const Motion there_and_back = [](double time) {
        const double way = time <= 1.0 ? 10.0 * time : 10.0 - 5.0 * (time - 1.0);
        const double arch = 0.3 * std::sin(std::numbers::pi * time / 2.0);
        return Pose{.x = Vector3(0.6, 0, 0.8) * way + Vector3(0.8, 0, -0.6) * arch + Vector3(7, 0.5 + arch, -3),
                    .v = {0.6, 5, 0.8}};
    };
    const auto scene = balls(1);
    const Evidence evidence = moved(scene, {there_and_back}, 201, 0.01);
    CHECK(only("slide_m", evidence) == Approx(5.0));
    CHECK(only("farthest_m", evidence) == Approx(std::hypot(10.0, 0.3)));
    CHECK(only("sideways_m", evidence) == Approx(0.3));
    CHECK(only("last_speed_m_per_s", evidence) == Approx(std::sqrt(26.0)));
}

TEST_CASE("the angle turned goes beyond a whole turn, and the spin is told from the one about the vertical") {
    const Motion turns = [](double time) {
        return Pose{.x = Vector3::Zero(),
                    .v = Vector3::Zero(),
                    .w = {3, -4, 0},
                    .orientation = Quaternion(Eigen::AngleAxisd(-4.0 * time, Vector3::UnitY()))};
    };
    const auto scene = balls(1);
    const Evidence evidence = moved(scene, {turns}, 301, 0.01);
    CHECK(only("turned_rad", evidence) == Approx(12.0));
    CHECK(only("spin_rad_per_s", evidence) == Approx(5.0));
    CHECK(only("vertical_spin_rad_per_s", evidence) == Approx(4.0));
}

TEST_CASE("the period of a swing lies between passages in one direction") {
    const double period = 0.73;  // s
    const Motion swings = [&](double time) {
        return Pose{.x = {std::cos(2.0 * std::numbers::pi * time / period), 0, 0}, .v = Vector3::Zero()};
    };
    const auto scene = balls(1);
    CHECK(only("swing_period_s", moved(scene, {swings}, 10000, 0.001)) == Approx(period).epsilon(1e-6));
    CHECK(take("swing_period_s", moved(scene, {swings}, 1200, 0.001)).empty());  // one passage
}

TEST_CASE("twins are compared from their starts on, each with its own") {
    const auto along = [](const Vector3& start, double speed) {
        return [=](double time) { return Pose{.x = start + time * Vector3(speed, 0, 0), .v = {speed, 0, 0}}; };
    };
    const auto scene = balls(4);
    const Evidence evidence =
        moved(scene, {along({0, 0, 0}, 2.0), along({0, 0, 5}, 3.0), along({8, 0, 0}, 2.0), along({8, 0, 5}, 2.5)},
              11, 0.1);
    for (const char* const measure : {"twin_distance_m", "twin_velocity_m_per_s"}) {
        const std::vector<double> values = take(measure, evidence);
        REQUIRE(values.size() == 2);
        CHECK(values[0] < 1e-15);
        CHECK(values[1] == Approx(0.5));
    }
    CHECK(take("slide_m", evidence).size() == 4);
}

TEST_CASE("a slab that only slides or only turns goes as far as the closed forms say") {
    const Slab slab;
    CHECK(slide_of(slab, 3.0, 0.0) == Approx(9.0 / (2.0 * 0.3 * 9.81)).epsilon(1e-6));
    CHECK(slide_of(slab, 0.0, 10.0) == Approx(0.0).margin(1e-9));
}

TEST_CASE("a slab that turns slides farther, the more the faster it turns") {
    double before = slide_of({}, 3.0, 0.0);
    for (const double spin : {1.0, 2.0, 5.0, 10.0, 20.0}) {
        const double now = slide_of({}, 3.0, spin);
        CHECK(now > before);
        before = now;
    }
}

TEST_CASE("the slide of a slab scales as mechanics does, and hardly knows how high the slab is") {
    const double way = slide_of({}, 3.0, 10.0);
    CHECK(way == Approx(2.8104).epsilon(1e-4));
    CHECK(slide_of({.height = 0.0}, 3.0, 10.0) == Approx(way).epsilon(1e-3));
    CHECK(slide_of({}, 3.0, -10.0) == Approx(way).epsilon(1e-9));
    // Four times as long and as high, at twice the speed and half the spin, takes four times the way.
    CHECK(slide_of({.side = 4.0, .height = 0.8}, 6.0, 5.0) == Approx(4.0 * way).epsilon(1e-6));
    CHECK(slide_of({.height = 0.0, .friction = 0.1, .gravity = 29.43}, 3.0, 10.0) ==
          Approx(slide_of({.height = 0.0}, 3.0, 10.0)).epsilon(1e-9));
}
