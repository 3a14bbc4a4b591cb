// Cases of sliding, rolling and static friction, and of hovering bodies without friction.
#include "demos/reports/stability/stability.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace pushfactor::demos::reports::stability {

namespace {
// Allowed error of a sliding distance, as a factor of speed x step: a step uses its final speed for its whole
// length, and the body stops within the last one.
constexpr double first_order = 1.5;

const Check straight_on{"sideways_m", 1e-6};
const Check no_spin{"vertical_spin_rad_per_s", 1e-6};
const Check not_turned{"turned_rad", 1e-6};

constexpr int count = 16;
constexpr double ring = 4.5;  // m, radius

double direction(int i) {
    return 2.0 * std::numbers::pi * i / count;
}

// 16 bodies like this one in a ring that slide outwards, each in a different direction relative to its axes.
SceneDescription in_16_directions(const std::string& name, const BodyDescription& floor, BodyDescription body,
                                  double speed, double friction) {
    SceneDescription scene = touching(name, {floor}, 0.8);
    const BodyDescription middle = body;
    for (int i = 0; i < count; ++i) {
        body.name = fmt::format("{} {}", middle.name, i + 1);
        body.position = along(direction(i), ring) + middle.position;
        body.velocity = along(direction(i), speed);
        scene.bodies.push_back(body);
    }
    return with_friction(scene, friction);
}

// The ground is level, and gravity is inclined by `angle` towards +x.
SceneDescription on_slope(const std::string& name, std::vector<BodyDescription> bodies, double height,
                          double angle) {
    bodies.insert(bodies.begin(), ground());
    SceneDescription scene = touching(name, std::move(bodies), height);
    scene.gravity = usual_gravity * Vector3(elementary::sin(angle), -elementary::cos(angle), 0);
    return scene;
}

// Cubes, each turned by a different angle about the normal of the slope, friction 0.5.
SceneDescription cubes_on_slope(double angle) {
    std::vector<BodyDescription> cubes;
    for (const double turn : {0.0, 0.2, 0.4, 0.25 * std::numbers::pi, 1.0, 1.3}) {
        const auto i = static_cast<int>(cubes.size());
        cubes.push_back(cube(i, {0, 0.5, 1.6 * static_cast<double>(i) - 4.0}));
        cubes.back().orientation = turned(turn);
    }
    return on_slope("slope", cubes, 0.6, angle);
}

// Balls of radius 0.5 m, of 1 kg and of 10 kg, at rest, and where `across` is not zero one that begins to roll
// across the slope at that speed.
SceneDescription balls_on_slope(double angle, double across) {
    std::vector<BodyDescription> balls{ball(0.5, {0, 0.5, 0}), ball(0.5, {0, 0.5, 2})};
    balls.back().name = "heavy ball";
    balls.back().mass = 10.0;
    if (across != 0.0) {
        balls.push_back(ball(0.5, {0, 0.5, -2}, {0, 0, -across}));
        balls.back().name = "ball across";
        balls.back().angular_velocity = rolling(balls.back().velocity, 0.5);
    }
    return on_slope("balls-on-slope", balls, 0.5, angle);
}

// 16 cubes in a grid that slide in the same direction, each turned by a different angle about the vertical.
SceneDescription cubes_turned_16_ways(double speed, double friction) {
    SceneDescription scene = touching("cubes-turned-16-ways", {ground()}, 0.8);
    for (int i = 0; i < count; ++i) {
        scene.bodies.push_back(cube(i, {4.0 * (i % 4) - 6.0, 0.5, 2.0 * std::floor(i / 4) - 3.0}, {speed, 0, 0}));
        scene.bodies.back().orientation = turned(0.25 * direction(i));
    }
    return with_friction(scene, friction);
}

using Plane = Eigen::Vector2d;            // x and z
using Moving = Eigen::Vector<double, 6>;  // x, z, angle; their rates

// Of a slab of 1 kg.
double inertia_of(const Slab& slab) {
    return slab.side * slab.side / 6.0;
}

double energy_of(const Slab& slab, const Moving& now) {
    return 0.5 * (now.segment<2>(3).squaredNorm() + inertia_of(slab) * now[5] * now[5]);
}

Moving rate_of(const Slab& slab, const Moving& now) {
    const double below = 0.5 * slab.height;
    Eigen::Matrix<double, 2, 4> places, directions;
    Eigen::Matrix<double, 3, 4> balance;  // weight, moments about z and x, of loads 1
    for (int i = 0; i < 4; ++i) {
        const Plane corner = 0.5 * slab.side * Plane(i < 2 ? 1 : -1, i % 2 == 0 ? 1 : -1);
        const Plane place = Eigen::Rotation2Dd(-now[2]) * corner;
        const Plane sliding = now.segment<2>(3) + now[5] * Plane(place.y(), -place.x());
        places.col(i) = place;
        directions.col(i) = sliding.stableNormalized();
        balance.col(i) << 1.0, place - slab.friction * below * directions.col(i);
    }
    Eigen::Matrix<double, 4, 3> linear;
    linear << Eigen::Vector4d::Ones(), places.transpose();
    const Eigen::Matrix3d system = balance * linear;
    const Eigen::Vector4d loads = linear * (slab.gravity * system.inverse().col(0));
    Moving rate;
    rate << now.tail<3>(), 0, 0, 0;
    for (int i = 0; i < 4; ++i) {
        const Plane force = -slab.friction * loads[i] * directions.col(i);
        rate.segment<2>(3) += force;
        rate[5] += (places(1, i) * force.x() - places(0, i) * force.y()) / inertia_of(slab);
    }
    return rate;
}

// Cubes that turn on the spot about the vertical, some one way and some the other.
SceneDescription spinning_cubes(double spin, double friction) {
    SceneDescription scene = touching("spinning-cubes", {ground()}, 0.5);
    for (int i = 0; i < 4; ++i) {
        scene.bodies.push_back(cube(i, {2.0 * i - 3.0, 0.5, 0}));
        scene.bodies.back().orientation = turned(0.35 * i);
        scene.bodies.back().angular_velocity = {0, i % 2 == 0 ? spin : -spin, 0};
    }
    return with_friction(scene, friction);
}

}  // namespace

SceneDescription cubes_in_16_directions(double speed, double friction, bool on_box) {
    return in_16_directions("cone-16-directions", on_box ? wall("ground", {16, 0.5, 16}, {0, -0.25, 0}) : ground(),
                            box("cube", Vector3::Ones(), {0, 0.5, 0}), speed, friction);
}

SceneDescription spinning_slab(double speed, double spin, double friction) {
    BodyDescription slab = box("slab", {1, 0.2, 1}, {0, 0.1, 0}, {speed, 0, 0});
    slab.angular_velocity = {0, spin, 0};
    SceneDescription scene = touching("spinning-slab", {ground(), slab}, 0.6);
    scene.gravity = {0, -9.81, 0};
    return with_friction(scene, friction);
}

double slide_of(const Slab& slab, double speed, double spin) {
    Moving now;
    now << 0, 0, 0, speed, 0, spin;
    const double start = energy_of(slab, now);
    // RK4. Both speeds vanish at the same time, and steps shrink with them.
    for (double left = 1.0; left > 1e-5; left = std::sqrt(energy_of(slab, now) / start)) {
        const double h = 1e-3 * std::max(left, 1e-3);  // s
        const Moving k1 = rate_of(slab, now);
        const Moving k2 = rate_of(slab, now + 0.5 * h * k1);
        const Moving k3 = rate_of(slab, now + 0.5 * h * k2);
        const Moving k4 = rate_of(slab, now + h * k3);
        now += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    }
    return now.head<2>().norm();
}

Chapter slopes() {
    constexpr double friction = 0.5;
    Chapter chapter{"slopes",
                    "Cubes turned about the normal of a slope, friction 0.5: they hold, or slide with g (sin - mu "
                    "cos); balls roll with 5/7 g sin until that needs more than mu"};
    const auto sliding_on = [](double angle) {
        return usual_gravity * (std::sin(angle) - friction * std::cos(angle));
    };
    for (const double angle : {0.3, 0.45, 0.5, 0.6}) {
        const double sliding = sliding_on(angle);
        const bool slides = sliding > 0.0;
        const std::string outcome = slides ? "moving" : "rest";
        for (const Steps& steps : both_steps) {
            chapter.add(steps, fmt::format("slope-{}-rad", angle), cubes_on_slope(angle), "3", outcome,
                        {{"acceleration_m_per_s2", 1e-6, slides ? sliding : 0.0}, no_spin},
                        of_both(outcome, {{}, slides ? std::optional(seat / steps.dt) : std::nullopt}),
                        angle == 0.6);
        }
    }
    for (const Steps& steps : both_steps) {
        chapter.add(steps, "slope-0.45-rad-60-s", cubes_on_slope(0.45), "70", "rest",
                    {{"drift_after_10_s_m", 1e-9}, no_spin}, of_both("rest"));
    }
    for (const double angle : {0.6, 1.0, 1.2}) {
        const bool slips = std::tan(angle) > 3.5 * friction;
        const double rolling = 5.0 / 7.0 * usual_gravity * std::sin(angle);
        for (const Steps& steps : both_steps) {
            chapter.add(steps, fmt::format("balls-on-slope-{}-rad", angle),
                        balls_on_slope(angle, slips ? 0.0 : 2.0), "1", "moving",
                        {{"acceleration_m_per_s2", 1e-6, slips ? sliding_on(angle) : rolling}}, of_both("moving"),
                        angle == 1.0);
        }
    }
    return chapter;
}

Chapter directions() {
    constexpr double speed = 3.0;     // m/s
    constexpr double friction = 0.3;  // mu
    constexpr double way = speed * speed / (2.0 * friction * usual_gravity);
    Chapter chapter{"directions",
                    "Cubes that slide at 3 m/s in 16 directions relative to their edges, friction 0.3: v^2 / (2 mu "
                    "g) straight on, without turning"};
    const auto add = [&chapter](const std::string& name, const SceneDescription& scene, bool quick = false) {
        for (const Steps& steps : both_steps) {
            chapter.add(steps, name, scene, "3", "rest",
                        {{"slide_m", first_order * speed * steps.dt, way}, straight_on, no_spin, not_turned},
                        of_both("rest", {{}, seat, seat / steps.dt, seat}), quick);
        }
    };
    add("cone-16-directions", cubes_in_16_directions(speed, friction, false), true);
    add("cone-16-directions-on-a-box", cubes_in_16_directions(speed, friction, true));
    add("cubes-turned-16-ways", cubes_turned_16_ways(speed, friction));
    return chapter;
}

Chapter slab() {
    constexpr double speed = 3.0;  // m/s
    constexpr double spin = 10.0;  // rad/s
    const double way = slide_of({}, speed, spin);
    Chapter chapter{"slab",
                    "A slab 1 x 0.2 x 1 m that slides at 3 m/s and turns by 10 rad/s, friction 0.3: goes as far as "
                    "quadrature says at any step"};
    // First order: half a step at the first speed. exact has a square instead of the cone, whose second tangent
    // slows a spinning body too much.
    for (const Steps& steps : both_steps) {
        chapter.add(steps, "spinning-slab", spinning_slab(speed, spin, Slab{}.friction), "4", "rest",
                    {{"slide_m", 0.01 * way + 0.5 * speed * steps.dt, way}},
                    {{"default", "rest"}, {"exact", "rest", {1.0}}}, true);
    }
    return chapter;
}

Chapter rolls() {
    constexpr double speed = 3.0;     // m/s
    constexpr double friction = 0.3;  // mu
    constexpr double seconds = 1.0;
    // It slides until it rolls, with 5/7 of its speed.
    constexpr double sliding = 2.0 * speed / (7.0 * friction * usual_gravity);  // s
    constexpr double rolls_at = 5.0 / 7.0 * speed;                              // m/s
    constexpr double way = 0.5 * (speed + rolls_at) * sliding + rolls_at * (seconds - sliding);
    Chapter chapter{"rolling",
                    "Balls that slide in 16 directions begin to roll at 5/7 of their speed; cubes that turn on the "
                    "spot stop after w^2 / (2 mu g r / I)"};
    for (const Steps& steps : both_steps) {
        chapter.add(
            steps, "balls-16-directions",
            in_16_directions("balls-16-directions", ground(), ball(0.5, {0, 0.5, 0}), speed, friction), "1",
            "moving",
            {{"last_speed_m_per_s", 1e-6, rolls_at}, {"slide_m", first_order * speed * steps.dt, way}, straight_on},
            of_both("moving"), true);
    }
    constexpr double spin = 10.0;  // rad/s
    // Friction at the corners, sqrt(2) / 2 m from the axis, over the moment of inertia, both of 1 kg.
    const double slowing = friction * usual_gravity * std::sqrt(0.5) * 6.0;  // rad/s^2
    for (const Steps& steps : both_steps) {
        chapter.add(
            steps, "spinning-cubes", spinning_cubes(spin, friction), "3", "rest",
            {{"turned_rad", first_order * spin * steps.dt, spin * spin / (2.0 * slowing)}, {"farthest_m", 1e-6}},
            of_both("rest", {{}, seat}), true);
    }
    return chapter;
}

Chapter hovering() {
    Chapter chapter{"hovering",
                    "Cubes 1 and 5 mm above a plane whose weight a force holds: nothing slows or turns them"};
    SceneDescription scene = touching("hovering-cubes", {ground()}, 0.5);
    for (int i = 0; i < 4; ++i) {
        const double gap = i == 3 ? 0.001 : 0.005;  // m
        // Away from each other.
        const BodyDescription one = cube(i, {0, 0.5 + gap, 1.6 * i - 2.4}, along(-0.3 * i, 1.0));
        scene.forces.push_back({.body = one.name, .force = -*one.mass * scene.gravity});
        scene.bodies.push_back(one);
    }
    for (const Steps& steps : both_steps) {
        chapter.add(steps, "hovering-cubes", scene, "5", "moving",
                    {{"deflection_m_per_s", 1e-12}, {"spin_rad_per_s", 1e-12}}, of_both("moving"), true);
    }
    return chapter;
}

}  // namespace pushfactor::demos::reports::stability
