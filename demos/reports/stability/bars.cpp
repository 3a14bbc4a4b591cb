// Cases with bars, and scenes with little or nothing in them.
#include "demos/reports/stability/cases.h"
#include "demos/reports/stability/scenes.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace pushfactor::demos::reports::stability {

namespace {

constexpr double rod_length = 1.0, rod_thickness = 0.04;  // m
constexpr int links = 5;
constexpr double link_length = 0.5;  // m

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

// A ball of 2 kg that hangs at `depth` [m] on bars of these lengths [m], all between the same two points.
SceneDescription hanging(const std::vector<double>& lengths, double depth) {
    SceneDescription scene = scene_of("hanging", {ball(0.1, {0, -depth, 0})});
    scene.bodies.back().mass = 2.0;
    for (const double length : lengths)
        scene.distances.push_back({.a = {}, .b = {"ball", Vector3::Zero()}, .length = length});
    return scene;
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

}  // namespace

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

std::vector<Chapter> bar_chapters() {
    return {chains(), ball_joints(), redundant_bars(), little()};
}

}  // namespace pushfactor::demos::reports::stability
