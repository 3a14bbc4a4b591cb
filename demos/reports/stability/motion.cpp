// What is fast, turns or bounces.
#include "demos/reports/stability/chapters.h"
#include "demos/reports/stability/scenes/small.h"

#include <fmt/format.h>

namespace pushfactor::demos::reports::stability {

Chapter impacts() {
    Chapter chapter{"impacts", "Fast bodies that hit: nothing goes through, nothing is thrown back", {}};
    for (const double gap : {3.0, 4.1, 5.2}) {
        chapter.cases.push_back({.name = fmt::format("cube-200-m-per-s-from-{}", gap),
                                 .own = falling_cube(gap, 200.0),
                                 .options = {{"seconds", "2"}},
                                 .wanted = "rest",
                                 .checks = {{.measure = "max_penetration_m", .bar = 1e-3},
                                            {.measure = "max_upward_speed_m_per_s", .bar = 0.01}},
                                 .expected = with_paper("rest", {"paper", gap == 3.0 ? "creep" : "fly"}),
                                 .quick = gap == 4.1});
    }
    for (const double speed : {10.0, 50.0, 200.0, 1000.0, 1e4}) {
        // It goes through the plate, except where a step happens to end inside.
        const Expected paper = speed == 10.0 ? Expected{"paper", "rest", {0.022}} : Expected{"paper", "tunnel"};
        chapter.cases.push_back({.name = fmt::format("ball-on-plate-{}-m-per-s", speed),
                                 .own = ball_on_plate(speed),
                                 .options = {{"seconds", "2"}},
                                 .wanted = "rest",
                                 .checks = {{.measure = "depth_m", .bar = 1e-3}},
                                 .expected = with_paper("rest", paper),
                                 .quick = speed == 1000.0});
    }
    return chapter;
}

Chapter passing() {
    Chapter chapter{"passing", "A ball that passes an edge at a distance of its radius: is not deflected", {}};
    for (const double speed : {60.0, 200.0}) {
        for (const bool plate : {true, false}) {
            const engine::Vector3 size = plate ? engine::Vector3(2, 0.1, 2) : engine::Vector3(1, 1, 1);
            chapter.cases.push_back({.name = fmt::format("past-{}-{}-m-per-s", plate ? "plate" : "cube", speed),
                                     .own = ball_past(size, speed),
                                     .options = {{"seconds", "0.3"}},
                                     .wanted = "moving",
                                     .checks = {{.measure = "deflection_m_per_s", .bar = 1e-9}},
                                     .expected = with_paper("moving", {"paper", "moving"}),
                                     .quick = speed == 200.0});
        }
    }
    return chapter;
}

Chapter turning() {
    Chapter chapter{
        "turning", "Free bodies that turn fast or about their middle axis, 60 s: energy and spins stay", {}};
    const Check energy{.measure = "relative_energy_change", .bar = 0.01};
    const Check spins{.measure = "relative_spin_change", .bar = 0.01};
    const Check momentum{.measure = "relative_angular_momentum_change", .bar = 1e-12};
    const Case rod{.name = "free-rod",
                   .own = free_rod(70.7),
                   .options = {{"seconds", "60"}},
                   .wanted = "moving",  // in its place
                   .checks = {energy, spins, momentum},
                   .expected = with_paper("moving", {"paper", "moving", {{200.0, 200.0}}}),
                   .quick = true};
    chapter.cases.push_back(rod);
    // More than half a turn a step.
    Case faster = rod;
    faster.name = "free-rod-200-rad-per-s";
    faster.own = free_rod(200.0);
    faster.quick = false;
    chapter.cases.push_back(faster);
    // Its spins are no constants.
    Case uneven = rod;
    uneven.name = "free-box";
    uneven.own = free_box();
    uneven.quick = false;
    uneven.checks = {energy, momentum};
    uneven.expected = with_paper("moving", {"paper", "moving", {4.0}});
    chapter.cases.push_back(uneven);
    return chapter;
}

Chapter bounces() {
    Chapter chapter{"bounces", "Restitution 1: energy stays, bounces are equally high", {}};
    chapter.cases.push_back({.name = "tumbling-box",
                             .own = tumbling_box(),
                             .options = {{"seconds", "20"}},
                             .wanted = "moving",
                             .checks = {{.measure = "relative_energy_change", .bar = 1e-3}},
                             .expected = with_paper("moving", {"paper", "fly"})});
    chapter.cases.push_back({.name = "bouncing-ball",
                             .own = bouncing_ball(),
                             .options = {{"seconds", "8"}},
                             .wanted = "moving",
                             .checks = {{.measure = "spread_of_5_apexes_m", .bar = 1e-9}},
                             .expected = with_paper("moving", {"paper", "fly"}),
                             .quick = true});
    return chapter;
}

}  // namespace pushfactor::demos::reports::stability
