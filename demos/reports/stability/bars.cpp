// Bars, and scenes with little or nothing in them.
#include "demos/reports/stability/chapters.h"
#include "demos/reports/stability/scenes/small.h"
#include "demos/reports/stability/scenes/thin.h"

#include <fmt/format.h>

#include <numbers>

namespace pushfactor::demos::reports::stability {

Chapter chains() {
    Chapter chapter{
        "chains", "Twenty links of 1 kg and an end of up to 1000 kg, from the horizontal, substeps auto, 10 s", {}};
    struct End {
        int mass;
        Expected paper;
    };
    const std::vector<End> ends{{1, {"paper", "moving", {0.03, 0.08}}},
                                {100, {"paper", "moving", {0.04, 0.5}}},
                                {1000, {"paper", "moving", {0.2, 200.0}}}};
    for (const auto& [mass, paper] : ends) {
        const double swing = 10.0 * (20.0 * mass + 190.0);  // J, from the horizontal to straight down
        chapter.cases.push_back({.name = fmt::format("chain-{}-kg", mass),
                                 .scene = "chain",
                                 .options = {{"end-mass", std::to_string(mass)}, {"substeps", "auto"}},
                                 .wanted = "moving",
                                 .checks = {{.measure = "max_length_error_m", .bar = 0.01},
                                            {.measure = "energy_change_at_end_j", .bar = 0.02, .scale = swing}},
                                 .expected = with_paper("moving", paper),
                                 .quick = mass == 1000});
    }
    return chapter;
}

Chapter redundant_bars() {
    constexpr double weight = 20.0;  // N
    Chapter chapter{
        "redundant-bars",
        "The same bar many times, and bars that contradict each other: finite, forces bounded, residual said",
        {}};
    for (const std::size_t count : {1U, 2U, 8U, 100U, 1000U}) {
        chapter.cases.push_back({.name = fmt::format("same-bar-{}-times", count),
                                 .own = hanging(std::vector<double>(count, 1.0), 1.0),
                                 .options = {{"seconds", "5"}},
                                 .wanted = "rest",
                                 .checks = {{.measure = "largest_force_n", .bar = 1.5, .scale = weight},
                                            {.measure = "residual_m_per_s_median", .bar = 1e-6}},
                                 .expected = with_paper("rest", {"paper", "rest"}),
                                 .quick = count == 8});
    }
    // The forces are those of one solve, 2.5e10 N, and do not grow from step to step.
    chapter.cases.push_back({.name = "bars-that-contradict",
                             .own = hanging({1.0, 1.1}, 1.05),
                             .options = {{"seconds", "20"}},
                             .wanted = "rest",
                             .checks = {{.measure = "largest_force_n", .bar = 1e11},
                                        {.measure = "residual_m_per_s_median", .bar = 0.1, .at_least = true}},
                             .expected = with_paper("rest", {"paper", "rest"}),
                             .quick = true});
    return chapter;
}

Chapter ball_joints() {
    Chapter chapter{"ball-joints",
                    "Bars of length 0: a rod hung by its end has the period of the elliptic integral, a chain of "
                    "five rods holds",
                    {}};
    add_at_both_steps(chapter, [](double step) {
        constexpr double angle = 1.0;  // rad
        const double period = rod_pendulum_period(angle);
        const double rate = 2.0 * std::numbers::pi / period;  // rad/s
        return Case{.name = "rod-pendulum",
                    .own = rod_pendulum(angle),
                    .options = {{"seconds", "20"}},
                    .wanted = "moving",
                    .checks = {{.measure = "swing_period_s",
                                .bar = 0.25 * rate * rate * step * step,
                                .target = period,
                                .scale = period},
                               {.measure = "max_length_error_m", .bar = 0.01}},
                    .expected = of_both("moving"),
                    .quick = true};
    });
    add_at_both_steps(chapter, [](double step) {
        constexpr double angle = 0.7;  // rad
        return Case{.name = "ball-joint-chain",
                    .own = ball_joint_chain(angle),
                    .options = {{"seconds", "10"}},
                    .wanted = "moving",
                    .checks = {{.measure = "max_length_error_m", .bar = 0.3 * step},
                               {.measure = "energy_change_at_end_j",
                                .bar = 3.0 * step,
                                .scale = ball_joint_chain_swing(angle)}},
                    .expected = of_both("moving"),
                    .quick = true};
    });
    return chapter;
}

Chapter little() {
    Chapter chapter{"little", "Scenes with little in them: no answer is undefined", {}};
    SceneDescription nothing;
    nothing.name = "nothing";
    Case one{.name = "nothing",
             .own = nothing,
             .options = {{"seconds", "3"}},
             .wanted = "rest",
             .expected = of_both("rest"),
             .quick = true};
    chapter.cases.push_back(one);
    one.name = "overlapping-walls";
    one.own = overlapping_walls();
    chapter.cases.push_back(one);
    Pile weightless;
    weightless.gravity = 0.0;
    one.name = "no-gravity";
    one.own = pile(weightless);
    chapter.cases.push_back(one);
    return chapter;
}

}  // namespace pushfactor::demos::reports::stability
