// What is fast, turns or bounces.
#include "demos/reports/stability/cases.h"
#include "demos/reports/stability/scenes/scenes.h"

#include <fmt/format.h>

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
        // Under paper it falls on below the plate, except where a step happens to end inside.
        const bool stops = speed == 10.0;
        chapter.add(fmt::format("ball-on-plate-{}-m-per-s", speed), ball_on_plate(speed), options, "rest",
                    {{"depth_m", 1e-3}},
                    with_paper("rest", stops ? "rest" : "moving", stops ? Reached{0.022} : Reached{}),
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

// They do not leave their place, so `rest` is their outcome.
Chapter turning() {
    Chapter chapter{"turning",
                    "Free bodies that turn fast or about their middle axis, 60 s: energy and spins stay"};
    const Check energy{"relative_energy_change", 0.01}, spins{"relative_spin_change", 0.01};
    const Check momentum{"relative_angular_momentum_change", 1e-12};
    const OptionTexts options{{"seconds", "60"}};
    const Expectations of_rods = with_paper("rest", "rest", {200.0, 200.0});
    chapter.add("free-rod", free_rod(70.7), options, "rest", {energy, spins, momentum}, of_rods, true);
    // More than half a turn per step.
    chapter.add("free-rod-200-rad-per-s", free_rod(200.0), options, "rest", {energy, spins, momentum}, of_rods);
    // Its spins are not constant.
    chapter.add("free-box", free_box(), options, "rest", {energy, momentum}, with_paper("rest", "rest", {4.0}));
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

}  // namespace

std::vector<Chapter> motion_chapters() {
    return {impacts(), passing(), turning(), bounces()};
}

}  // namespace pushfactor::demos::reports::stability
