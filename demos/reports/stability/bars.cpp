// Bars, and scenes with little or nothing in them.
#include "demos/reports/stability/cases.h"
#include "demos/reports/stability/scenes/scenes.h"

#include <fmt/format.h>

#include <numbers>

namespace pushfactor::demos::reports::stability {

namespace {

Chapter chains() {
    Chapter chapter{"chains",
                    "Twenty links of 1 kg and an end of up to 1000 kg, from the horizontal, substeps auto, 10 s"};
    const auto add = [&chapter](int mass, const std::string& outcome, const char* paper, const Reached& reached) {
        const double swing = 10.0 * (20.0 * mass + 190.0);  // J, from the horizontal to straight down
        chapter.add(fmt::format("chain-{}-kg", mass), "chain",
                    {{"end-mass", std::to_string(mass)}, {"substeps", "auto"}}, outcome,
                    {{"max_length_error_m", 0.01}, {"energy_change_at_end_j", 0.02, 0.0, swing}},
                    with_paper(outcome, paper, reached), mass == 1000);
    };
    add(1, "moving", "moving", {0.03, 0.08});
    // A link above its start that rises counts as flying; the light links of a chain do whip there.
    add(100, "fly", "moving", {});
    add(1000, "moving", "fly", {});
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

std::vector<Chapter> bar_chapters() {
    return {chains(), ball_joints(), redundant_bars(), little()};
}

}  // namespace pushfactor::demos::reports::stability
