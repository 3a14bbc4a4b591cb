#include "demos/reports/stability/scenes/friction.h"

#include "demos/reports/stability/scenes/pieces.h"

#include <cmath>
#include <numbers>

namespace pushfactor::demos::reports::stability {

namespace {

using engine::Vector3;

constexpr int count = 16;
constexpr double ring = 4.5;  // m, radius

BodyDescription cube(int number, const Vector3& position) {
    return box("cube " + std::to_string(number + 1), Vector3::Ones(), position);
}

SceneDescription with_friction(SceneDescription scene, double friction) {
    for (BodyDescription& body : scene.bodies) body.friction = friction;
    return scene;
}

double direction(int i) {
    return 2.0 * std::numbers::pi * i / count;
}

}  // namespace

SceneDescription cubes_in_16_directions(double speed, double friction, bool on_box) {
    SceneDescription scene = touching("cone-16-directions", {ground()});
    if (on_box) scene.bodies = {wall("ground", {16, 0.5, 16}, {0, -0.25, 0})};
    for (int i = 0; i < count; ++i) {
        BodyDescription one = cube(i, along(direction(i), ring) + Vector3(0, 0.5, 0));
        one.velocity = along(direction(i), speed);
        scene.bodies.push_back(one);
    }
    scene.view = seen_from(0.8);
    return with_friction(scene, friction);
}

SceneDescription cubes_turned_16_ways(double speed, double friction) {
    SceneDescription scene = touching("cubes-turned-16-ways", {ground()});
    for (int i = 0; i < count; ++i) {
        BodyDescription one = cube(i, Vector3(4.0 * (i % 4) - 6.0, 0.5, 2.0 * std::floor(i / 4) - 3.0));
        one.orientation = turned(0.25 * direction(i));
        one.velocity = {speed, 0, 0};
        scene.bodies.push_back(one);
    }
    scene.view = seen_from(0.8);
    return with_friction(scene, friction);
}

SceneDescription balls_in_16_directions(double speed, double friction) {
    SceneDescription scene = touching("balls-16-directions", {ground()});
    for (int i = 0; i < count; ++i) {
        scene.bodies.push_back(
            ball(0.5, along(direction(i), ring) + Vector3(0, 0.5, 0), along(direction(i), speed)));
        scene.bodies.back().name += " " + std::to_string(i + 1);
    }
    scene.view = seen_from(0.8);
    return with_friction(scene, friction);
}

SceneDescription spinning_slab(double speed, double spin, double friction) {
    BodyDescription slab = box("slab", {1, 0.2, 1}, {0, 0.1, 0});
    slab.velocity = {speed, 0, 0};
    slab.angular_velocity = {0, spin, 0};
    SceneDescription scene = touching("spinning-slab", {ground(), slab});
    scene.gravity = {0, -9.81, 0};
    scene.view = seen_from(0.6);
    return with_friction(scene, friction);
}

SceneDescription spinning_cubes(double spin, double friction) {
    SceneDescription scene = touching("spinning-cubes", {ground()});
    for (int i = 0; i < 4; ++i) {
        BodyDescription one = cube(i, {2.0 * i - 3.0, 0.5, 0});
        one.orientation = turned(0.35 * i);
        one.angular_velocity = {0, i % 2 == 0 ? spin : -spin, 0};
        scene.bodies.push_back(one);
    }
    scene.view = seen_from(0.5);
    return with_friction(scene, friction);
}

SceneDescription slope(double angle) {
    SceneDescription scene = touching("slope", {ground()});
    const std::vector<double> angles{0.0, 0.2, 0.4, 0.25 * std::numbers::pi, 1.0, 1.3};  // rad
    for (std::size_t i = 0; i < angles.size(); ++i) {
        BodyDescription one = cube(static_cast<int>(i), {0, 0.5, 1.6 * static_cast<double>(i) - 4.0});
        one.orientation = turned(angles[i]);
        scene.bodies.push_back(one);
    }
    scene.gravity = usual_gravity * Vector3(std::sin(angle), -std::cos(angle), 0);
    scene.view = seen_from(0.6);
    return scene;
}

SceneDescription balls_on_slope(double angle, double across) {
    SceneDescription scene = touching("balls-on-slope", {ground(), ball(0.5, {0, 0.5, 0}), ball(0.5, {0, 0.5, 2})});
    scene.bodies.back().name = "heavy ball";
    scene.bodies.back().mass = 10.0;
    if (across != 0.0) {
        BodyDescription one = ball(0.5, {0, 0.5, -2}, {0, 0, -across});
        one.name = "ball across";
        one.angular_velocity = rolling(one.velocity, 0.5);
        scene.bodies.push_back(one);
    }
    scene.gravity = usual_gravity * Vector3(std::sin(angle), -std::cos(angle), 0);
    scene.view = seen_from(0.5);
    return scene;
}

SceneDescription hovering_cubes() {
    SceneDescription scene = touching("hovering-cubes", {ground()});
    for (int i = 0; i < 4; ++i) {
        const double gap = i == 3 ? 0.001 : 0.005;  // m
        BodyDescription one = cube(i, {0, 0.5 + gap, 1.6 * i - 2.4});
        one.velocity = along(-0.3 * i, 1.0);  // away from each other
        scene.forces.push_back({.body = one.name, .force = -*one.mass * scene.gravity});
        scene.bodies.push_back(one);
    }
    scene.view = seen_from(0.5);
    return scene;
}

}  // namespace pushfactor::demos::reports::stability
