// The scenes of convex polyhedra, and the dominoes, against mechanics.
#include "demos/scenes/named/arch.h"
#include "demos/scenes/named/platonic.h"
#include "engine/collision/polyhedron.h"
#include "tests/catch.h"
#include "tests/scene_fixture.h"
#include "tests/settings.h"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace pushfactor;
using namespace pushfactor::demos;
using pushfactor::tests::Run;
using pushfactor::tests::simulate;

namespace {

// The largest way of a body from its place [m] after `seconds`.
double farthest_way(Simulation run, double seconds) {
    const std::vector<engine::Body> start = run.scene().world.bodies;
    tests::advance(run, seconds);
    double way = 0.0;
    for (std::size_t i = 0; i < start.size(); ++i)
        way = std::max(way, (run.scene().world.bodies[i].position - start[i].position).norm());
    return way;
}

double way_of_arch(const char* voussoirs, double thickness, double friction, double seconds) {
    const std::string thick = std::to_string(thickness);
    Settings settings = tests::awake_settings("exact");
    settings.friction = friction;
    return farthest_way(simulate("arch", settings, {{"voussoirs", voussoirs}, {"thickness", thick}}), seconds);
}

// Times at which each domino has leaned by 0.2 rad [s].
std::vector<double> falls(const char* height, double seconds) {
    Simulation run = simulate("dominoes", tests::awake_settings("default"), {{"height", height}, {"count", "30"}});
    std::vector<double> times;
    while (run.sample().time < seconds) {
        run.advance();
        const std::vector<engine::Body>& bodies = run.scene().world.bodies;
        while (times.size() + 1 < bodies.size()) {
            const engine::Vector3 up = bodies[times.size() + 1].orientation * engine::Vector3::UnitY();
            if (std::acos(std::min(1.0, up.y())) < 0.2) break;
            times.push_back(run.sample().time);
        }
    }
    return times;
}

}  // namespace

TEST_CASE("limit analysis of an arch of many voussoirs gives Milankovitch's thickness") {
    CHECK(scenes::least_thickness({.voussoirs = 1001}, 100.0) == Approx(0.10748).epsilon(1e-4));
    CHECK(scenes::least_thickness({.voussoirs = 15}, 100.0) < 0.10748);
    CHECK(scenes::can_stand({.voussoirs = 15, .thickness = 0.12}, 0.7));
    CHECK_FALSE(scenes::can_stand({.voussoirs = 15, .thickness = 0.09}, 0.7));
    CHECK_FALSE(scenes::can_stand({.voussoirs = 15, .thickness = 0.12}, 0.3));
    // A flatter arch may be thinner, and a thicker one needs no less friction at its springings than none.
    CHECK(scenes::least_thickness({.voussoirs = 31, .half_angle = 1.0}, 100.0) < 0.05);
}

TEST_CASE("an arch stands and falls where limit analysis says, in thickness and in friction") {
    const scenes::ArchShape shape{.voussoirs = 15};
    const double thickness = scenes::least_thickness(shape, 10.0), friction = scenes::least_friction(shape);
    CHECK(way_of_arch("15", 1.03 * thickness, 10.0, 4.0) < 1e-3);
    CHECK(way_of_arch("15", 0.97 * thickness, 10.0, 4.0) > 0.1);
    CHECK(way_of_arch("15", 0.12, 1.03 * friction, 4.0) < 1e-3);
    CHECK(way_of_arch("15", 0.12, 0.97 * friction, 4.0) > 0.1);
}

TEST_CASE("an arch of 0.12 stands for a minute, one of 0.09 falls", "[long]") {
    CHECK(way_of_arch("31", 0.12, 0.7, 60.0) < 1e-3);
    CHECK(way_of_arch("31", 0.09, 0.7, 4.0) > 0.5);
}

TEST_CASE("the wave along dominoes settles to a speed, which doubles when they are four times as large") {
    const auto speed = [](const std::vector<double>& times, std::size_t from, std::size_t to) {
        return static_cast<double>(to - from) / (times.at(to) - times.at(from));
    };
    const std::vector<double> small = falls("0.5", 6.0), large = falls("2", 12.0);
    REQUIRE(small.size() == 30);
    REQUIRE(large.size() == 30);
    // In dominoes per second: the length of one grows by 4.
    CHECK(speed(small, 18, 26) == Approx(speed(small, 10, 18)).epsilon(0.05));
    CHECK(4.0 * speed(large, 10, 26) / speed(small, 10, 26) == Approx(2.0).epsilon(0.05));
}

TEST_CASE("a hundred regular solids come to rest in the funnel within 20 s") {
    Run run(simulate("platonic", tests::awake_settings("default")));
    run.advance(20.0);
    CHECK(run.measurements.outcome() != Outcome::tunnel);
    CHECK(run.simulation.sample().max_speed < 0.01);
    CHECK(run.simulation.sample().energy_gain < 1e-3 * 1000.0);
    double lowest = 1e300;
    for (const engine::Body& body : run.simulation.scene().world.bodies) {
        if (!body.is_static()) lowest = std::min(lowest, body.position.y());
    }
    CHECK(lowest > 0.3);
}

TEST_CASE("the regular solids have as many corners and faces as Euclid says") {
    const std::array<std::pair<std::size_t, std::size_t>, 5> expected{{{4, 4}, {8, 6}, {6, 8}, {20, 12}, {12, 20}}};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const FramedPolyhedron solid = make_polyhedron(scenes::regular_solids()[i].points);
        CHECK(solid.shape.mesh->hull().vertices.size() == expected[i].first);
        CHECK(solid.shape.mesh->hull().faces.size() == expected[i].second);
        // All moments of a regular solid are equal.
        CHECK(solid.shape.moments.x() == Approx(solid.shape.moments.y()).epsilon(1e-12));
        CHECK(solid.shape.moments.x() == Approx(solid.shape.moments.z()).epsilon(1e-12));
    }
}
