// Bodies that pass each other closely, and a box that slides over a floor of flush boxes, go on as if nothing were
// there.
#include "engine/bodies/diagnostics.h"
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/scene_fixture.h"
#include "tests/settings.h"

#include <algorithm>
#include <cmath>

using namespace pushfactor;
using namespace pushfactor::demos;
using engine::Body;
using engine::Quaternion;
using engine::Vector3;
using tests::Random;

namespace {

SceneDescription without_friction(std::vector<BodyDescription> bodies, const Vector3& gravity) {
    SceneDescription scene;
    scene.contacts = true;
    scene.gravity = gravity;
    scene.bodies = std::move(bodies);
    for (BodyDescription& body : scene.bodies) body.friction = 0.0;
    return scene;
}

BodyDescription cube_on_edge(const char* name, const Vector3& position) {
    return {.name = name,
            .position = position,
            .orientation = Quaternion(Eigen::AngleAxisd(0.25 * M_PI, Vector3::UnitZ()))};
}

// The largest deviation from free flight of any movable body after any of the steps [m/s and rad/s].
double disturbance(const SceneDescription& scene, const char* preset, int steps) {
    const Settings settings = tests::awake_settings(preset);
    Simulation simulation(build_scene(scene, settings), settings);
    double most = 0.0;
    for (int n = 1; n <= steps; ++n) {
        simulation.advance();
        for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
            const Body& body = simulation.scene().world.bodies[i];
            if (body.is_static()) continue;
            const Vector3 free = scene.bodies[i].velocity + n / 60.0 * scene.gravity;
            most = std::max({most, (velocity(body) - free).norm(), angular_velocity(body).norm()});
        }
    }
    return most;
}

void check_undisturbed(const SceneDescription& scene, int steps) {
    for (const char* preset : {"default", "exact"}) {
        INFO(preset);
        CHECK(disturbance(scene, preset, steps) < 1e-9);
    }
}

// A floor of flush boxes with its top at y = 0, around the way of what slides along x from the origin.
struct Floor {
    Vector3 tile = Vector3::Ones();  // m
    double offset = 0.0;             // m, of a seam from the origin
    double bond = 0.0;               // of the tile, by which every other row is shifted
    double turn = 0.0;               // rad about the vertical
};

std::vector<BodyDescription> tiles_of(const Floor& floor, double from, double until, double aside) {
    const Quaternion turn(Eigen::AngleAxisd(floor.turn, Vector3::UnitY()));
    const double span = until - from + aside;
    const int rows = static_cast<int>(span / floor.tile.z()), columns = static_cast<int>(span / floor.tile.x());
    std::vector<BodyDescription> tiles;
    for (int row = -rows; row <= rows; ++row) {
        for (int column = -columns; column <= columns; ++column) {
            const double shift = floor.offset + (row % 2 != 0 ? floor.bond : 0.0) * floor.tile.x();
            const Vector3 place = turn * Vector3((column + 0.5) * floor.tile.x() + shift, -0.5 * floor.tile.y(),
                                                 (row + 0.5) * floor.tile.z() + 0.3 * floor.offset);
            const double reach = 0.5 * std::hypot(floor.tile.x(), floor.tile.z());
            if (place.x() < from - reach || place.x() > until + reach || std::abs(place.z()) > aside + reach)
                continue;
            BodyDescription tile{.name = "tile " + std::to_string(tiles.size()), .shape = BoxShape{floor.tile}};
            tile.position = place;
            tile.orientation = turn;
            tiles.push_back(tile);
        }
    }
    return tiles;
}

// The largest change of the horizontal velocity [m/s] of a box of `size` [m], turned by `turn` [rad] about the
// vertical, that slides for a second and a half at 4 m/s.
double change_on(const Floor& floor, const Vector3& size, double turn, const Quaternion& tilt, const char* preset) {
    const Vector3 along(4.0, 0, 0);
    std::vector<BodyDescription> bodies = tiles_of(floor, -size.norm(), 6.0 + size.norm(), size.norm());
    bodies.push_back({.name = "slider", .shape = BoxShape{size}, .mass = 1.0});
    bodies.back().position = {0, 0.5 * size.y(), 0};
    bodies.back().orientation = Quaternion(Eigen::AngleAxisd(turn, Vector3::UnitY()));
    bodies.back().velocity = along;
    for (BodyDescription& body : bodies) {
        body.position = tilt * body.position;
        body.orientation = tilt * body.orientation;
        body.velocity = tilt * body.velocity;
    }
    const Settings settings = tests::awake_settings(preset);
    const SceneDescription scene = without_friction(std::move(bodies), tilt * Vector3(0, -10, 0));
    Simulation simulation(build_scene(scene, settings), settings);
    double most = 0.0;
    for (int n = 0; n < 90; ++n) {
        simulation.advance();
        Vector3 now = tilt.conjugate() * velocity(simulation.scene().world.bodies.back());
        now.y() = 0.0;
        most = std::max(most, (now - along).norm());
    }
    return most;
}

}  // namespace

TEST_CASE("a cube on its edge falls past a peg of the same shape, 1 cm away, as if it were alone", "[meet]") {
    SceneDescription scene = without_friction(
        {cube_on_edge("peg", Vector3::Zero()), cube_on_edge("cube", {std::sqrt(2.0) + 0.01, 3, 0})}, {0, -9.81, 0});
    scene.bodies[1].mass = 1.0;
    check_undisturbed(scene, 72);
}

TEST_CASE("a cube that passes an edge at 10 m/s, 1 cm away, goes on undisturbed", "[meet]") {
    SceneDescription scene = without_friction(
        {cube_on_edge("obstacle", Vector3::Zero()), cube_on_edge("mover", {-1.2, std::sqrt(2.0) + 0.01, 0})},
        Vector3::Zero());
    scene.bodies[1].mass = 1.0;
    scene.bodies[1].velocity = {10, 0, 0};
    check_undisturbed(scene, 30);
}

TEST_CASE("a ball that passes another at 100 m/s, 5 mm away, goes on undisturbed, and so does the other",
          "[meet]") {
    SceneDescription scene =
        without_friction({{.name = "target", .shape = SphereShape{0.5}, .mass = 1.0},
                          {.name = "ball", .shape = SphereShape{0.5}, .mass = 1.0, .position = {-0.08, 1.005, 0}}},
                         Vector3::Zero());
    scene.bodies[1].velocity = {100, 0, 0};
    check_undisturbed(scene, 6);
}

TEST_CASE("a cube that slides over flush tiles at 4 m/s keeps its velocity, however they are laid or turned",
          "[meet]") {
    for (const char* preset : {"default", "exact"}) {
        for (const Floor& floor :
             {Floor{}, Floor{.tile = {0.5, 1, 0.5}, .offset = 0.13},
              Floor{.tile = {1, 1, 2.3}, .offset = 0.5, .bond = 0.5},
              Floor{.tile = {1.7, 0.2, 0.6}, .bond = 0.3, .turn = 0.3}, Floor{.turn = 0.25 * M_PI}}) {
            for (const double turn : {0.0, 0.5}) {
                INFO(preset << ", tile " << floor.tile.transpose() << " turned by " << floor.turn << ", cube "
                            << turn);
                CHECK(change_on(floor, Vector3::Ones(), turn, Quaternion::Identity(), preset) < 1e-5);
            }
        }
    }
}

TEST_CASE("boxes of any size slide over tiles of any size at 4 m/s without a change of velocity, on any slope",
          "[meet]") {
    Random random(44);
    for (int i = 0; i < 40; ++i) {
        Floor floor{.tile = random.vector(0.3, 2.5)};
        floor.tile.y() = random.in(0.05, 1.0);
        floor.offset = random.in(-1.0, 1.0);
        floor.bond = i % 2 ? 0.0 : random.in(0.0, 1.0);
        floor.turn = i % 4 < 2 ? 0.0 : random.in(-3.1, 3.1);
        const Vector3 size = random.vector(0.2, 1.5);
        const double turn = i % 3 ? random.in(-3.1, 3.1) : 0.0;
        const Quaternion tilt = i % 5 ? Quaternion::Identity() : random.rotation();
        INFO("case " << i);
        CHECK(change_on(floor, size, turn, tilt, i % 2 ? "default" : "exact") < 1e-5);  // below 1e-10
    }
}
