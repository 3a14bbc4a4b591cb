// Cases of floors of flush boxes, which should behave like a single box.
#include "demos/reports/stability/stability.h"

#include <fmt/format.h>

namespace pushfactor::demos::reports::stability {

namespace {

constexpr double thickness = 0.5;    // m, of a floor
constexpr double behind = 8.0;       // m, distance back to the floor of the twins
constexpr double way_to_stop = 0.5;  // m, of the bodies that are stopped

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
    const bool even = ride.uneven == 0.0;
    std::vector<BodyDescription> found{box("cube", Vector3::Ones(), {0.03, 0.5, even ? -1.6 : -0.8}),
                                       box("plank", {2, 0.2, 0.2}, {0, 0.1, even ? 1.55 : 0.8})};
    for (BodyDescription& one : found) one.friction = 0.0;
    // A ball would fall into the lower boxes.
    if (even) found.push_back(ball(0.5, {0.15, 0.5, 0}));
    for (BodyDescription& one : found) {
        one.velocity = along(ride.angle, ride.speed);
        one.orientation = turned(ride.angle);
        one.position.z() += 1.6 * elementary::sin(ride.angle);  // so that the path is centred on the floor
    }
    if (even) found.back().angular_velocity = rolling(found.back().velocity, 0.5);
    return found;
}

// A floor from x = -2.25 to 3.75 m, whose boxes from x = 1.5 m on are higher by `step` [m].
SceneDescription short_floor(const std::string& name, BodyDescription body, double speed, double friction,
                             double step) {
    SceneDescription scene = touching(name, {}, 0.5);
    lay(scene, {.corner = {-2.25, 0, -0.95}, .lanes = 3});
    for (BodyDescription& tile : scene.bodies) {
        if (tile.position.x() > 1.5) tile.position.y() += step;
    }
    body.velocity = {speed, 0, 0};
    scene.bodies.push_back(body);
    return with_friction(scene, friction);
}

void add_rides(Chapter& chapter, double speed, const std::string& seconds, const std::string& outcome) {
    for (const double uneven : {0.0, 0.0005}) {
        for (const double angle : {0.0, 0.4}) {
            const std::string name =
                fmt::format("seams-{}-{}-m-per-s-{}-rad", uneven == 0.0 ? "flush" : "uneven", speed, angle);
            for (const Steps& steps : both_steps) {
                chapter.add(steps, name, seam_floor({.speed = speed, .angle = angle, .uneven = uneven}), seconds,
                            outcome, {{"twin_distance_m", 1e-6}, {"twin_velocity_m_per_s", 1e-6}},
                            of_both(outcome, {1.5 * seat, 1.5 * seat / steps.dt}), speed == 4.0 && uneven == 0.0);
            }
        }
    }
}

}  // namespace

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
    std::vector<BodyDescription> twins = riders(ride);
    scene.bodies.insert(scene.bodies.end(), twins.begin(), twins.end());
    for (BodyDescription& one : twins) {
        one.name += " on the single box";
        one.position.x() -= behind;
        scene.bodies.push_back(one);
    }
    return scene;
}

Chapter seams() {
    Chapter chapter{"seams",
                    "Cubes, planks and balls on flush boxes, also with every other box 0.5 mm lower: as on a "
                    "single box; but walls and steps stop them"};
    add_rides(chapter, 0.1, "3", "creep");  // 0.1 m/s counts as creeping
    add_rides(chapter, 4.0, "0.8", "moving");
    add_rides(chapter, 50.0, "0.067", "moving");
    constexpr double slop = 0.002;  // m, of a cube of 1 m
    const auto add_stop = [&chapter](const std::string& name, const SceneDescription& scene, double beyond) {
        for (const Steps& steps : both_steps) {
            // With short steps default keeps a speed of a tenth of `seat` per step, which nothing removes.
            const char* const outcome = steps.dt < 0.01 && beyond == slop ? "creep" : "rest";
            chapter.add(steps, name, scene, "4", "rest", {{"farthest_m", beyond, way_to_stop}},
                        {{"default", outcome}, {"exact", "rest"}}, name == "cube-stopped-by-step");
        }
    };
    const BodyDescription cube = box("cube", Vector3::Ones(), {1.0 - way_to_stop, 0.5, 0});
    SceneDescription by_wall = short_floor("stopped-by-wall", cube, 4.0, 0.0, 0.0);
    by_wall.bodies.push_back(wall("wall", {0.3, 1.5, 2.25}, {1.65, 0.75, 0.175}));
    add_stop("cube-stopped-by-wall", by_wall, slop);
    // The step is as high as its centre, so that it does not tip.
    const BodyDescription slab = box("slab", {1, 0.1, 1}, {1.0 - way_to_stop, 0.05, 0});
    add_stop("slab-stopped-by-step", short_floor("slab-stopped-by-step", slab, 4.0, 0.0, 0.05), slop);
    // At the step it has 1 m/s left. It tips about the edge with 0.73 rad/s, to 0.033 rad, its centre goes on by
    // 0.015 m, and it falls back.
    add_stop("cube-stopped-by-step", short_floor("cube-stopped-by-step", cube, 2.0, 0.3, 0.05), 0.02);
    return chapter;
}

}  // namespace pushfactor::demos::reports::stability
