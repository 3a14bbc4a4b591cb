// Cases with fast, spinning or bouncing bodies, with floors of flush boxes, which should behave like a single box,
// with bars, and scenes with little or nothing in them.
#include "demos/reports/stability/stability.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace pushfactor::demos::reports::stability {

namespace {

SceneDescription tumbling_box() {
    SceneDescription scene =
        with_friction(touching("tumbling-box", {ground(), box("box", {1, 0.4, 0.2}, {0, 2, 0})}), 0.0);
    scene.bodies.back().restitution = 1.0;
    scene.bodies.back().angular_velocity = {1, 4, 3};
    return scene;
}

constexpr double rod_length = 1.0, rod_thickness = 0.04;  // m
constexpr int links = 5;
constexpr double link_length = 0.5;  // m

// A rod whose upper end hangs on `above`, which is given in the frame of the body of that name.
void hang(const std::string& name, double length, double angle, double from, const std::string& above,
          const Vector3& hook, SceneDescription& scene) {
    const Vector3 down(elementary::sin(angle), -elementary::cos(angle), 0);
    BodyDescription rod = box(name, {rod_thickness, length, rod_thickness}, (from + 0.5 * length) * down);
    rod.orientation = inclined(angle);
    scene.bodies.push_back(rod);
    scene.distances.push_back({.a = {above, hook}, .b = {name, {0, 0.5 * length, 0}}, .length = 0.0});
    scene.view = seen_from(0.1);
}

// A ball of 2 kg that hangs at `depth` [m] on bars of these lengths [m], all between the same two points.
SceneDescription hanging(const std::vector<double>& lengths, double depth) {
    SceneDescription scene = scene_of("hanging", {ball(0.1, {0, -depth, 0})});
    scene.bodies.back().mass = 2.0;
    for (const double length : lengths)
        scene.distances.push_back({.a = {}, .b = {"ball", Vector3::Zero()}, .length = length});
    return scene;
}

constexpr double floor_thickness = 0.5;  // m
constexpr double behind = 8.0;           // m, distance back to the floor of the twins
constexpr double way_to_stop = 0.5;      // m, of the bodies that are stopped

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
            const Vector3 middle((i + 0.5) * floor.side, top - 0.5 * floor_thickness, (k + 0.5) * floor.side);
            scene.bodies.push_back(wall("tile " + std::to_string(i + 1) + " " + std::to_string(k + 1),
                                        {floor.side, floor_thickness, floor.side}, floor.corner + middle));
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

SceneDescription bouncing_ball() {
    SceneDescription scene = touching("bouncing-ball", {ground(), ball(0.1, {0, 2.1, 0})});
    scene.bodies.back().restitution = 1.0;
    return scene;
}

double rod_pendulum_period(double angle) {
    // Squared rate of small swings: m g l / 2 over the moment of inertia about the end; m = 1 kg.
    const double inertia = rod_length * rod_length / 3.0 + rod_thickness * rod_thickness / 12.0;  // m^2
    const double rate = std::sqrt(usual_gravity * 0.5 * rod_length / inertia);                    // rad/s
    return 4.0 * std::comp_ellint_1(elementary::sin(0.5 * angle)) / rate;
}

SceneDescription ball_joint_chain(double angle) {
    SceneDescription scene = scene_of("ball-joint-chain", {});
    std::string above = "world";
    for (int i = 0; i < links; ++i) {
        const Vector3 hook = i == 0 ? Vector3(Vector3::Zero()) : Vector3(-0.5 * link_length * Vector3::UnitY());
        hang("rod " + std::to_string(i + 1), link_length, angle, i * link_length, above, hook, scene);
        above = scene.bodies.back().name;
    }
    return scene;
}

SceneDescription seam_floor(const Ride& ride) {
    SceneDescription scene = touching("seam-floor", {}, 0.8);
    Floor tiles{.corner = {-1.2, 0, -3.0}};
    if (ride.uneven != 0.0)
        tiles = {.corner = {-1.2, 0, -2.2}, .rows = 15, .lanes = 11, .side = 0.4, .uneven = ride.uneven};
    lay(scene, tiles);
    const Vector3 size(tiles.rows * tiles.side, floor_thickness, tiles.lanes * tiles.side);
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

Chapter impacts() {
    Chapter chapter{"impacts", "Fast bodies that hit: nothing goes through, nothing is thrown back"};
    const OptionTexts options{{"seconds", "2"}};
    for (const double gap : {3.0, 4.1, 5.2}) {
        const BodyDescription cube = box("cube", Vector3::Ones(), {0, 0.5 + gap, 0}, {0, -200, 0});
        chapter.add(fmt::format("cube-200-m-per-s-from-{}", gap), touching("falling-cube", {ground(), cube}),
                    options, "rest", {{"max_penetration_m", 1e-3}, {"max_upward_speed_m_per_s", 0.01}},
                    with_paper("rest", gap == 3.0 ? "creep" : "fly"), gap == 4.1);
    }
    for (const double speed : {10.0, 50.0, 200.0, 1000.0, 1e4}) {
        // Lying on the plate the ball's centre is at height 0. Under paper it goes through, except where a step
        // happens to end inside.
        const bool stops = speed == 10.0;
        chapter.add(fmt::format("ball-on-plate-{}-m-per-s", speed),
                    touching("ball-on-plate",
                             {wall("plate", {4, 0.1, 4}, {0, -0.15, 0}), ball(0.1, {0, 0.32, 0}, {0, -speed, 0})}),
                    options, "rest", {{"depth_m", 1e-3}},
                    with_paper("rest", stops ? "rest" : "tunnel", stops ? Reached{0.022} : Reached{}),
                    speed == 1000.0);
    }
    return chapter;
}

Chapter passing() {
    Chapter chapter{"passing", "A ball that passes an edge at a distance of its radius: is not deflected"};
    for (const double speed : {60.0, 200.0}) {
        for (const bool plate : {true, false}) {
            const Vector3 size = plate ? Vector3(2, 0.1, 2) : Vector3(1, 1, 1);
            SceneDescription scene = touching(
                "ball-past",
                {wall("box", size, Vector3::Zero()), ball(0.1, {0.5 * size.x() + 0.2, 2.13, 0}, {0, -speed, 0})});
            scene.gravity.setZero();
            chapter.add(fmt::format("past-{}-{}-m-per-s", plate ? "plate" : "cube", speed), scene,
                        {{"seconds", "0.3"}}, "moving", {{"deflection_m_per_s", 1e-9}},
                        with_paper("moving", "moving"), speed == 200.0);
        }
    }
    return chapter;
}

// Bodies that spin in place.
Chapter turning() {
    Chapter chapter{"turning",
                    "Free bodies that turn fast or about their middle axis, 60 s: energy and spins stay"};
    const auto add = [&chapter](const std::string& name, const std::string& scene_name, const std::string& body,
                                const Vector3& size, const Vector3& spin, const Checks& checks,
                                const Reached& of_paper, bool quick = false) {
        SceneDescription scene = scene_of(scene_name, {box(body, size, Vector3::Zero())});
        scene.gravity.setZero();
        scene.bodies.front().angular_velocity = spin;
        chapter.add(name, scene, {{"seconds", "60"}}, "moving", checks, with_paper("moving", "moving", of_paper),
                    quick);
    };
    const Check energy{"relative_energy_change", 0.01}, spins{"relative_spin_change", 0.01};
    const Check momentum{"relative_angular_momentum_change", 1e-12};
    const Vector3 rod(2, 0.1, 0.1);  // m; they turn about their length and across
    add("free-rod", "free-rod", "rod", rod, {70.7, 70.7, 0}, {energy, spins, momentum}, {200.0, 200.0}, true);
    // More than half a turn per step.
    add("free-rod-200-rad-per-s", "free-rod", "rod", rod, {200, 200, 0}, {energy, spins, momentum}, {200.0, 200.0});
    // Most of it about its middle axis: its spins are not constant.
    add("free-box", "free-box", "box", {1, 4, 9}, {0.1, 3, 0.1}, {energy, momentum}, {4.0});
    return chapter;
}

Chapter bounces() {
    Chapter chapter{"bounces", "Restitution 1: energy stays, bounces are equally high"};
    chapter.add("tumbling-box", tumbling_box(), {{"seconds", "20"}}, "moving", {{"relative_energy_change", 1e-3}},
                with_paper("moving", "fly"));
    chapter.add("bouncing-ball", bouncing_ball(), {{"seconds", "8"}}, "moving", {{"spread_of_5_apexes_m", 1e-9}},
                with_paper("moving", "fly"), true);
    return chapter;
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

Chapter chains() {
    Chapter chapter{"chains",
                    "Twenty links of 1 kg and an end of up to 1000 kg, from the horizontal, substeps auto, 10 s"};
    const auto add = [&chapter](int mass, const Reached& reached) {
        const double swing = 10.0 * (20.0 * mass + 190.0);  // J, from the horizontal to straight down
        chapter.add(fmt::format("chain-{}-kg", mass), "chain",
                    {{"end-mass", std::to_string(mass)}, {"substeps", "auto"}}, "moving",
                    {{"max_length_error_m", 0.0015}, {"energy_change_at_end_j", 0.02, 0.0, swing}},
                    with_paper("moving", "moving", reached), mass == 1000);
    };
    add(1, {0.03, 0.08});
    add(100, {0.04, 0.5});
    add(1000, {0.2, 200.0});
    return chapter;
}

Chapter ball_joints() {
    Chapter chapter{"ball-joints",
                    "Bars of length 0: a rod hung by its end has the period of the elliptic integral, a chain of "
                    "five rods holds"};
    constexpr double high = 1.0, low = 0.7;  // rad
    SceneDescription pendulum = scene_of("rod-pendulum", {});
    hang("rod", rod_length, high, 0.0, "world", Vector3::Zero(), pendulum);
    const double period = rod_pendulum_period(high);
    const double rate = 2.0 * std::numbers::pi / period;  // rad/s
    for (const Steps& steps : both_steps) {
        const double beyond = 0.25 * rate * rate * steps.dt * steps.dt;
        chapter.add(steps, "rod-pendulum", pendulum, "20", "moving",
                    {{"swing_period_s", beyond, period, period}, {"max_length_error_m", 0.01}}, of_both("moving"),
                    true);
    }
    // J, to straight down.
    const double swing = links * usual_gravity * 0.5 * links * link_length * (1.0 - elementary::cos(low));
    for (const Steps& steps : both_steps) {
        chapter.add(
            steps, "ball-joint-chain", ball_joint_chain(low), "10", "moving",
            {{"max_length_error_m", 0.3 * steps.dt}, {"energy_change_at_end_j", 3.0 * steps.dt, 0.0, swing}},
            of_both("moving"), true);
    }
    return chapter;
}

Chapter redundant_bars() {
    constexpr double weight = 20.0;  // N
    Chapter chapter{
        "redundant-bars",
        "The same bar many times, and bars that contradict each other: finite, forces bounded, residual said"};
    for (const std::size_t count : {1U, 2U, 8U, 100U, 1000U}) {
        chapter.add(fmt::format("same-bar-{}-times", count), hanging(std::vector<double>(count, 1.0), 1.0),
                    {{"seconds", "5"}}, "rest",
                    {{"largest_force_n", 1.5, 0.0, weight}, {"residual_m_per_s_median", 1e-6}},
                    with_paper("rest", "rest"), count == 8);
    }
    // The forces are those of one solve, 2.5e10 N, and do not grow from step to step.
    chapter.add("bars-that-contradict", hanging({1.0, 1.1}, 1.05), {{"seconds", "20"}}, "rest",
                {{"largest_force_n", 1e11}, {.measure = "residual_m_per_s_median", .bar = 0.1, .at_least = true}},
                with_paper("rest", "rest"), true);
    return chapter;
}

Chapter little() {
    Chapter chapter{"little", "Scenes with little in them: no answer is undefined"};
    const auto add = [&chapter](const std::string& name, const SceneDescription& scene) {
        chapter.add(name, scene, {{"seconds", "3"}}, "rest", {}, of_both("rest"), true);
    };
    add("nothing", scene_of("nothing", {}));
    // Static boxes in each other, and a ball far from them as the only movable body.
    add("overlapping-walls",
        touching("overlapping-walls", {ground(), wall("one", Vector3::Ones(), {0, 0.3, 0}),
                                       wall("other", Vector3::Ones(), {0.2, 0.4, 0}), ball(0.1, {3, 0.1, 0})}));
    add("no-gravity", pile({.gravity = 0.0}));
    return chapter;
}

}  // namespace pushfactor::demos::reports::stability
