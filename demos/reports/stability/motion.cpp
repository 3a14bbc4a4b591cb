// Cases with fast, spinning or bouncing bodies, bars, and scenes with little or nothing in them.
#include "demos/reports/stability/cases.h"
#include "demos/reports/stability/scenes/scenes.h"

#include <fmt/format.h>

#include <numbers>

namespace pushfactor::demos::reports::stability {

namespace {

Chapter impacts() {
    Chapter chapter{"impacts", "Fast bodies that hit: nothing goes through, nothing is thrown back"};
    const OptionTexts options{{"seconds", "2"}};
    for (const double gap : {3.0, 4.1, 5.2}) {
        chapter.add(fmt::format("cube-200-m-per-s-from-{}", gap), falling_cube(gap, 200.0), options, "rest",
                    {{"max_penetration_m", 1e-3}, {"max_upward_speed_m_per_s", 0.01}},
                    with_paper("rest", gap == 3.0 ? "creep" : "fly"), gap == 4.1);
    }
    for (const double speed : {10.0, 50.0, 200.0, 1000.0, 1e4}) {
        // Under paper it goes through the plate, except where a step happens to end inside.
        const bool stops = speed == 10.0;
        chapter.add(fmt::format("ball-on-plate-{}-m-per-s", speed), ball_on_plate(speed), options, "rest",
                    {{"depth_m", 1e-3}},
                    with_paper("rest", stops ? "rest" : "tunnel", stops ? Reached{0.022} : Reached{}),
                    speed == 1000.0);
    }
    return chapter;
}

Chapter passing() {
    Chapter chapter{"passing", "A ball that passes an edge at a distance of its radius: is not deflected"};
    for (const double speed : {60.0, 200.0}) {
        for (const bool plate : {true, false}) {
            const engine::Vector3 size = plate ? engine::Vector3(2, 0.1, 2) : engine::Vector3(1, 1, 1);
            chapter.add(fmt::format("past-{}-{}-m-per-s", plate ? "plate" : "cube", speed), ball_past(size, speed),
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
    const Check energy{"relative_energy_change", 0.01}, spins{"relative_spin_change", 0.01};
    const Check momentum{"relative_angular_momentum_change", 1e-12};
    const OptionTexts options{{"seconds", "60"}};
    const Expectations of_rods = with_paper("moving", "moving", {200.0, 200.0});
    chapter.add("free-rod", free_rod(70.7), options, "moving", {energy, spins, momentum}, of_rods, true);
    // More than half a turn per step.
    chapter.add("free-rod-200-rad-per-s", free_rod(200.0), options, "moving", {energy, spins, momentum}, of_rods);
    // Its spins are not constant.
    chapter.add("free-box", free_box(), options, "moving", {energy, momentum},
                with_paper("moving", "moving", {4.0}));
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
    const auto moves = [](double) { return of_both("moving"); };
    constexpr double high = 1.0, low = 0.7;  // rad
    const double period = rod_pendulum_period(high);
    const double rate = 2.0 * std::numbers::pi / period;  // rad/s
    chapter.add_at_both_steps(
        "rod-pendulum", rod_pendulum(high), "20", "moving",
        [&](double step) -> Checks {
            return {{"swing_period_s", 0.25 * rate * rate * step * step, period, period},
                    {"max_length_error_m", 0.01}};
        },
        moves, true);
    chapter.add_at_both_steps(
        "ball-joint-chain", ball_joint_chain(low), "10", "moving",
        [](double step) -> Checks {
            return {{"max_length_error_m", 0.3 * step},
                    {"energy_change_at_end_j", 3.0 * step, 0.0, ball_joint_chain_swing(low)}};
        },
        moves, true);
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
    SceneDescription nothing;
    nothing.name = "nothing";
    for (const auto& [name, scene] :
         {std::pair("nothing", nothing), std::pair("overlapping-walls", overlapping_walls()),
          std::pair("no-gravity", pile({.gravity = 0.0}))})
        chapter.add(name, scene, {{"seconds", "3"}}, "rest", {}, of_both("rest"), true);
    return chapter;
}

}  // namespace

std::vector<Chapter> motion_chapters() {
    return {impacts(), passing(), turning(), bounces()};
}

std::vector<Chapter> bar_chapters() {
    return {chains(), ball_joints(), redundant_bars(), little()};
}

}  // namespace pushfactor::demos::reports::stability
