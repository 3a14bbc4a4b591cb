#include "demos/reports/stability/scenes/floor.h"

#include "demos/reports/stability/scenes/pieces.h"

#include <cmath>

namespace pushfactor::demos::reports::stability {

namespace {

using engine::Vector3;

constexpr double thickness = 0.5;  // m, of a floor
constexpr double behind = 8.0;     // m, from a floor back to the one of the twins

struct Floor {
    Vector3 corner;  // m, of its top, where x and z are least
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
    // It would fall into the lower boxes.
    if (ride.uneven == 0.0) found.push_back(ball(0.5, {0.15, 0.5, 0}));
    for (BodyDescription& one : found) {
        one.velocity = along(ride.angle, ride.speed);
        one.orientation = turned(ride.angle);
        one.position.z() += 1.6 * std::sin(ride.angle);  // so that it ends as far aside as it began
    }
    if (ride.uneven == 0.0) found.back().angular_velocity = rolling(found.back().velocity, 0.5);
    return found;
}

// Level from x = -2.25 to 3.75 m.
SceneDescription short_floor(const std::string& name, BodyDescription body, double speed, double friction) {
    SceneDescription scene = touching(name, {});
    lay(scene, {.corner = {-2.25, 0, -0.95}, .lanes = 3});
    body.velocity = {speed, 0, 0};
    scene.bodies.push_back(body);
    for (BodyDescription& one : scene.bodies) one.friction = friction;
    scene.view = seen_from(0.5);
    return scene;
}

// Of the short floor: raises the boxes from x = 1.5 m on by `height`.
void raise(SceneDescription& scene, double height) {
    for (BodyDescription& one : scene.bodies) {
        if (!one.mass && one.position.x() > 1.5) one.position.y() += height;
    }
}

}  // namespace

SceneDescription seam_floor(const Ride& ride) {
    SceneDescription scene = touching("seam-floor", {});
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
    scene.view = seen_from(0.8);
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
