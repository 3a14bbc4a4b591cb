// A scene and its line in the catalogue, as demos/EXTENDING.md shows them.
#include "demos/runs/simulation.h"
#include "demos/scenes/catalogue.h"
#include "demos/scenes/named/named_scenes.h"
#include "tests/catch.h"
#include "tests/settings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

using namespace pushfactor;
using namespace pushfactor::demos;
using engine::Vector3;
using scenes::view_of;

namespace {

// [example: scene]
constexpr std::array falling_row_parameters{
    Parameter{"count", "N", "number of dominoes [8]", 8, 1, 1000, true},
    Parameter{"tip", "RAD/S", "how fast the first one tips over at the start, rad/s [2]", 2, 0, 5},
};

SceneDescription describe_falling_row(const ParameterValues& parameters) {
    const Vector3 size(0.2, 1.0, 0.5);  // m
    const double spacing = 0.5;         // m
    SceneDescription scene;
    scene.contacts = true;
    scene.bodies.push_back({.name = "ground", .shape = PlaneShape{}});
    const int count = parameters.whole("count");
    for (int i = 0; i < count; ++i) {
        scene.bodies.push_back({.name = "domino " + std::to_string(i + 1),
                                .shape = BoxShape{size},
                                .mass = 1.0,
                                .position = Vector3(i * spacing, 0.5 * size.y(), 0)});
    }
    // The first one turns about its lower edge in front.
    BodyDescription& first = scene.bodies[1];
    first.angular_velocity = Vector3(0, 0, -parameters.number("tip"));
    first.velocity = first.angular_velocity.cross(Vector3(-0.5 * size.x(), 0.5 * size.y(), 0));
    const double length = count * spacing;
    scene.view = view_of(Vector3(0.5 * length, 0.4, 0), 0.5 * length);
    return scene;
}

constinit const SceneEntry falling_row{"falling-row",
                                       "The first of a row of dominoes tips over and takes the others with it.",
                                       falling_row_parameters, describe_falling_row};
// [end]

Simulation simulation_of(const SceneEntry& scene, const char* tip) {
    ParameterValues values(scene.parameters);
    REQUIRE(values.set(scene.parameters[1], tip));
    const Settings settings = tests::awake_settings("default");
    return Simulation(build_scene(scene.describe(values), settings), settings);
}

// Of each domino, whether it leans by more than 30 degrees.
std::vector<bool> tipped(const Simulation& simulation) {
    std::vector<bool> found;
    for (const engine::Body& body : simulation.scene().world.bodies) {
        const Vector3 up = body.orientation * Vector3::UnitY();
        if (!body.is_static()) found.push_back(up.y() < std::cos(std::numbers::pi / 6));
    }
    return found;
}

}  // namespace

TEST_CASE("example: dominoes tip over one after the other, and none without a first") {
    Simulation simulation = simulation_of(falling_row, "2");
    Simulation untouched = simulation_of(falling_row, "0");
    std::vector<bool> before = tipped(simulation);
    REQUIRE(before.size() == 8);
    for (int step = 0; step < 240; ++step) {
        simulation.advance();
        untouched.advance();
        const std::vector<bool> now = tipped(simulation);
        CHECK(std::is_sorted(now.rbegin(), now.rend()));  // those that have tipped are the first ones
        CHECK(std::count(now.begin(), now.end(), true) <= std::count(before.begin(), before.end(), true) + 1);
        before = now;
    }
    CHECK(std::count(before.begin(), before.end(), true) == 8);
    CHECK(tipped(untouched) == std::vector<bool>(8, false));
}
