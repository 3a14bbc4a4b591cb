// Bodies that slide, roll or hold by friction, and floors of flush boxes.
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

constexpr double thickness = 0.5;  // m, of a floor
constexpr double behind = 8.0;     // m, distance back to the floor of the twins

struct Floor {
    Vector3 corner;  // m, corner of its top with the smallest x and z
    int rows = 8;    // along x
    int lanes = 8;   // along z
    double side = 0.75;
    double uneven = 0.0;  // m
};

void lay(SceneDescription& scene, const Floor& floor) {
    for (int i = 0; i < floor.rows; ++i) {
        for (int k = 0; k < floor.lanes; ++k) {
            const double top = (i + k) % 2 == 0 ? 0.0 : -floor.uneven;
            const Vector3 middle((i + 0.5) * floor.side, top - 0.5 * thickness, (k + 0.5) * floor.side);
            scene.bodies.push_back(wall("tile " + std::to_string(i + 1) + " " + std::to_string(k + 1),
                                        {floor.side, thickness, floor.side}, floor.corner + middle));
        }
    }
}

std::vector<BodyDescription> riders(const Ride& ride) {
    BodyDescription cube = box("cube", Vector3::Ones(), {0.03, 0.5, ride.uneven == 0.0 ? -1.6 : -0.8});
    BodyDescription plank = box("plank", {2, 0.2, 0.2}, {0, 0.1, ride.uneven == 0.0 ? 1.55 : 0.8});
    cube.friction = plank.friction = 0.0;
    std::vector<BodyDescription> found{cube, plank};
    // A ball would fall into the lower boxes.
    if (ride.uneven == 0.0) found.push_back(ball(0.5, {0.15, 0.5, 0}));
    for (BodyDescription& one : found) {
        one.velocity = along(ride.angle, ride.speed);
        one.orientation = turned(ride.angle);
        one.position.z() += 1.6 * elementary::sin(ride.angle);  // so that the path is centred on the floor
    }
    if (ride.uneven == 0.0) found.back().angular_velocity = rolling(found.back().velocity, 0.5);
    return found;
}

// Level from x = -2.25 to 3.75 m.
SceneDescription short_floor(const std::string& name, BodyDescription body, double speed, double friction) {
    SceneDescription scene = touching(name, {}, 0.5);
    lay(scene, {.corner = {-2.25, 0, -0.95}, .lanes = 3});
    body.velocity = {speed, 0, 0};
    scene.bodies.push_back(body);
    for (BodyDescription& one : scene.bodies) one.friction = friction;
    return scene;
}

// Of the short floor: raises the boxes from x = 1.5 m on by `height`.
void raise(SceneDescription& scene, double height) {
    for (BodyDescription& one : scene.bodies) {
        if (!one.mass && one.position.x() > 1.5) one.position.y() += height;
    }
}

}  // namespace

SceneDescription cubes_in_16_directions(double speed, double friction, bool on_box) {
    SceneDescription scene = touching("cone-16-directions", {ground()}, 0.8);
    if (on_box) scene.bodies = {wall("ground", {16, 0.5, 16}, {0, -0.25, 0})};
    for (int i = 0; i < count; ++i) {
        BodyDescription one = cube(i, along(direction(i), ring) + Vector3(0, 0.5, 0));
        one.velocity = along(direction(i), speed);
        scene.bodies.push_back(one);
    }
    return with_friction(scene, friction);
}

SceneDescription cubes_turned_16_ways(double speed, double friction) {
    SceneDescription scene = touching("cubes-turned-16-ways", {ground()}, 0.8);
    for (int i = 0; i < count; ++i) {
        BodyDescription one = cube(i, Vector3(4.0 * (i % 4) - 6.0, 0.5, 2.0 * std::floor(i / 4) - 3.0));
        one.orientation = turned(0.25 * direction(i));
        one.velocity = {speed, 0, 0};
        scene.bodies.push_back(one);
    }
    return with_friction(scene, friction);
}

SceneDescription balls_in_16_directions(double speed, double friction) {
    SceneDescription scene = touching("balls-16-directions", {ground()}, 0.8);
    for (int i = 0; i < count; ++i) {
        scene.bodies.push_back(
            ball(0.5, along(direction(i), ring) + Vector3(0, 0.5, 0), along(direction(i), speed)));
        scene.bodies.back().name += " " + std::to_string(i + 1);
    }
    return with_friction(scene, friction);
}

SceneDescription spinning_slab(double speed, double spin, double friction) {
    BodyDescription slab = box("slab", {1, 0.2, 1}, {0, 0.1, 0});
    slab.velocity = {speed, 0, 0};
    slab.angular_velocity = {0, spin, 0};
    SceneDescription scene = touching("spinning-slab", {ground(), slab}, 0.6);
    scene.gravity = {0, -9.81, 0};
    return with_friction(scene, friction);
}

SceneDescription spinning_cubes(double spin, double friction) {
    SceneDescription scene = touching("spinning-cubes", {ground()}, 0.5);
    for (int i = 0; i < 4; ++i) {
        BodyDescription one = cube(i, {2.0 * i - 3.0, 0.5, 0});
        one.orientation = turned(0.35 * i);
        one.angular_velocity = {0, i % 2 == 0 ? spin : -spin, 0};
        scene.bodies.push_back(one);
    }
    return with_friction(scene, friction);
}

SceneDescription slope(double angle) {
    SceneDescription scene = touching("slope", {ground()}, 0.6);
    const std::vector<double> angles{0.0, 0.2, 0.4, 0.25 * std::numbers::pi, 1.0, 1.3};  // rad
    for (std::size_t i = 0; i < angles.size(); ++i) {
        BodyDescription one = cube(static_cast<int>(i), {0, 0.5, 1.6 * static_cast<double>(i) - 4.0});
        one.orientation = turned(angles[i]);
        scene.bodies.push_back(one);
    }
    scene.gravity = usual_gravity * Vector3(elementary::sin(angle), -elementary::cos(angle), 0);
    return scene;
}

SceneDescription balls_on_slope(double angle, double across) {
    SceneDescription scene =
        touching("balls-on-slope", {ground(), ball(0.5, {0, 0.5, 0}), ball(0.5, {0, 0.5, 2})}, 0.5);
    scene.bodies.back().name = "heavy ball";
    scene.bodies.back().mass = 10.0;
    if (across != 0.0) {
        BodyDescription one = ball(0.5, {0, 0.5, -2}, {0, 0, -across});
        one.name = "ball across";
        one.angular_velocity = rolling(one.velocity, 0.5);
        scene.bodies.push_back(one);
    }
    scene.gravity = usual_gravity * Vector3(elementary::sin(angle), -elementary::cos(angle), 0);
    return scene;
}

SceneDescription hovering_cubes() {
    SceneDescription scene = touching("hovering-cubes", {ground()}, 0.5);
    for (int i = 0; i < 4; ++i) {
        const double gap = i == 3 ? 0.001 : 0.005;  // m
        BodyDescription one = cube(i, {0, 0.5 + gap, 1.6 * i - 2.4});
        one.velocity = along(-0.3 * i, 1.0);  // away from each other
        scene.forces.push_back({.body = one.name, .force = -*one.mass * scene.gravity});
        scene.bodies.push_back(one);
    }
    return scene;
}

SceneDescription seam_floor(const Ride& ride) {
    SceneDescription scene = touching("seam-floor", {}, 0.8);
    const double low_x = -1.2;
    const bool even = ride.uneven == 0.0;
    const Floor tiles{.corner = {low_x, 0, even ? -3.0 : -2.2},
                      .rows = even ? 8 : 15,
                      .lanes = even ? 8 : 11,
                      .side = even ? 0.75 : 0.4,
                      .uneven = ride.uneven};
    lay(scene, tiles);
    const Vector3 size(tiles.rows * tiles.side, thickness, tiles.lanes * tiles.side);
    const Vector3 middle = tiles.corner + 0.5 * Vector3(size.x(), -size.y(), size.z());
    scene.bodies.push_back(wall("single", size, middle - Vector3(behind, 0, 0)));
    for (const BodyDescription& one : riders(ride)) scene.bodies.push_back(one);
    for (BodyDescription one : riders(ride)) {
        one.name += " on the single box";
        one.position.x() -= behind;
        scene.bodies.push_back(one);
    }
    return scene;
}

SceneDescription stopped_by_wall(double speed) {
    SceneDescription scene =
        short_floor("stopped-by-wall", box("cube", Vector3::Ones(), {1.0 - way_to_stop, 0.5, 0}), speed, 0.0);
    scene.bodies.push_back(wall("wall", {0.3, 1.5, 2.25}, {1.65, 0.75, 0.175}));
    return scene;
}

SceneDescription cube_stopped_by_step(double speed) {
    SceneDescription scene =
        short_floor("cube-stopped-by-step", box("cube", Vector3::Ones(), {1.0 - way_to_stop, 0.5, 0}), speed, 0.3);
    raise(scene, 0.05);
    return scene;
}

SceneDescription slab_stopped_by_step(double speed) {
    SceneDescription scene =
        short_floor("slab-stopped-by-step", box("slab", {1, 0.1, 1}, {1.0 - way_to_stop, 0.05, 0}), speed, 0.0);
    raise(scene, 0.05);
    return scene;
}

}  // namespace pushfactor::demos::reports::stability
