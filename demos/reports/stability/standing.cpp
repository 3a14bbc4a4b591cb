// Cubes that should stand.
#include "demos/reports/stability/chapters.h"
#include "demos/reports/stability/scenes/small.h"

#include <fmt/format.h>

namespace pushfactor::demos::reports::stability {

Chapter heavy_on_light() {
    Chapter chapter{"heavy-on-light", "A cube of up to 1e6 kg on a cube of 1 kg, 10 s: stands", {}};
    for (const char* const ratio : {"100", "1000", "1e4", "1e6"}) {
        const bool quick = std::string(ratio) == "1000";
        Case one{.name = fmt::format("heavy-on-light-{}", ratio),
                 .scene = "heavy-on-light",
                 .options = {{"mass-ratio", ratio}},
                 .wanted = "rest",
                 .checks = {{.measure = "max_penetration_m", .bar = 0.002}},
                 .expected = {{"default", "rest"}, {"paper", "fall"}},
                 .quick = quick};
        chapter.cases.push_back(one);
        // To rounding, where nothing is left to a slop.
        one.name += "-to-rounding";
        one.checks = {{.measure = "penetration_at_end_m", .bar = 1e-9}};
        one.expected = {{"exact", "rest"}};
        chapter.cases.push_back(one);
    }
    chapter.cases.push_back({.name = "light-on-heavy-1e6",
                             .scene = "heavy-on-light",
                             .options = {{"mass-ratio", "1e-6"}},
                             .wanted = "rest",
                             .checks = {{.measure = "max_penetration_m", .bar = 0.002}},
                             .expected = with_paper("rest", {"paper", "creep"})});
    return chapter;
}

Chapter heights() {
    Chapter chapter{"heights", "Stacks of 2 to 40 cubes that touch, 60 s: stand on their axis", {}};
    for (const char* const count : {"2", "5", "10", "20", "40"}) {
        chapter.cases.push_back(
            {.name = fmt::format("stack-of-{}", count),
             .scene = "stack",
             .options = {{"count", count}, {"gap", "-0.0001"}, {"seconds", "60"}},
             .wanted = "rest",
             .checks = {{.measure = "max_off_axis_m", .bar = 1e-3}},
             .expected = with_paper("rest", {"paper", std::stoi(count) < 10 ? "creep" : "fly"})});
    }
    return chapter;
}

Chapter steps() {
    Chapter chapter{"steps", "The stack of five at other steps than 1/60 s, 60 s: stands", {}};
    struct Step {
        const char *name, *dt, *substeps;
        std::vector<Expected> expected;
        bool quick = false;
    };
    const std::vector<Step> table{
        {"stack-dt-1-10", "1/10", "auto", with_paper("rest", {"paper", "fall"}), true},
        {"stack-dt-1-30", "1/30", "auto", with_paper("rest", {"paper", "fall"})},
        {"stack-dt-1-1000", "1/1000", "auto", with_paper("rest", {"paper", "creep"})},
        {"stack-dt-1-10-undivided", "1/10", "1", with_paper("rest", {"paper", "fall"})},
        {"stack-dt-1-30-undivided", "1/30", "1", with_paper("rest", {"paper", "fall"})},
        {"stack-dt-1", "1", "auto", with_paper("rest", {"paper", "fall"})},
    };
    for (const Step& step : table) {
        chapter.cases.push_back({.name = step.name,
                                 .scene = "stack",
                                 .options = {{"dt", step.dt}, {"substeps", step.substeps}, {"seconds", "60"}},
                                 .wanted = "rest",
                                 .checks = {{.measure = "max_off_axis_m", .bar = 1e-3}},
                                 .expected = step.expected,
                                 .quick = step.quick});
    }
    return chapter;
}

Chapter sizes_and_places() {
    Chapter chapter{"sizes-and-places",
                    "Piles of five cubes of 1 mm to 1 km, far from the origin, under other gravity: rest",
                    {}};
    const auto add = [&chapter](const std::string& name, const Pile& wanted, bool quick = false) {
        chapter.cases.push_back({.name = name,
                                 .own = pile(wanted),
                                 .options = {{"substeps", "auto"}},
                                 .wanted = "rest",
                                 .checks = {{.measure = "max_penetration_m", .bar = 0.002, .scale = wanted.side},
                                            {.measure = "max_off_axis_m", .bar = 1e-3, .scale = wanted.side}},
                                 .expected = with_paper("rest", {"paper", "creep"}),
                                 .quick = quick});
    };
    add("cubes-of-1-mm", {.side = 1e-3}, true);
    add("cubes-of-1-cm", {.side = 1e-2});
    add("cubes-of-1-km", {.side = 1e3});
    add("at-1e3-m", {.origin = engine::Vector3::Constant(1e3)});
    add("at-1e5-m", {.origin = engine::Vector3::Constant(1e5)});
    add("at-1e6-m", {.origin = engine::Vector3::Constant(1e6)}, true);
    add("at-1e7-m", {.origin = engine::Vector3::Constant(1e7)});
    add("gravity-1000", {.gravity = 1000.0});
    return chapter;
}

Chapter overlaps() {
    Chapter chapter{"overlaps", "Cubes that start in each other: separate without a velocity left", {}};
    const auto add = [&chapter](double overlap, const char* beta, const char* paper, bool quick = false) {
        chapter.cases.push_back({.name = fmt::format("overlap-{}-beta-{}", overlap, beta),
                                 .own = overlapping(overlap),
                                 .options = {{"beta", beta}, {"seconds", "5"}},
                                 .wanted = "rest",
                                 .checks = {{.measure = "max_upward_speed_m_per_s", .bar = 1e-6},
                                            {.measure = "penetration_at_end_m", .bar = 0.0021}},
                                 .expected = with_paper("rest", {"paper", paper}),
                                 .quick = quick});
        // The cones of eight points that push by a metre are not always solved to the tolerance.
        if (overlap == 1.0) chapter.cases.back().expected.front().reached = {1e-5};
    };
    for (const double overlap : {0.01, 0.1, 0.25, 0.5, 0.9, 1.0}) add(overlap, "0.2", "creep", overlap == 0.5);
    add(0.5, "0.05", "creep");
    add(1.0, "0.05", "creep");
    add(0.5, "1", "moving");
    add(1.0, "1", "moving");
    return chapter;
}

}  // namespace pushfactor::demos::reports::stability
