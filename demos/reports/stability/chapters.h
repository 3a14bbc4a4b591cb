// The chapters of the stress list.
#pragma once

#include "demos/reports/stability/cases.h"

namespace pushfactor::demos::reports::stability {

// What stands: towers under a heavy cube, high ones, other steps, sizes, places and gravity.
Chapter heavy_on_light();
Chapter heights();
Chapter steps();
Chapter sizes_and_places();
Chapter overlaps();

// Cards, planks and rods that stand.
Chapter thin();

// Members of the families: towers, walls, cards, piles.
Chapter structures();

// What is fast, turns or bounces.
Chapter impacts();
Chapter passing();
Chapter turning();
Chapter bounces();

// What slides, rolls or holds by friction, and what must not notice it.
Chapter slopes();
Chapter directions();
Chapter slab();
Chapter rolls();
Chapter hovering();

// Floors of flush boxes.
Chapter seams();

// Bars, and scenes with little or nothing in them.
Chapter chains();
Chapter ball_joints();
Chapter redundant_bars();
Chapter little();

// The same expectation of the presets default and exact.
inline std::vector<Expected> of_both(const std::string& outcome) {
    return {{.preset = "default", .outcome = outcome}, {.preset = "exact", .outcome = outcome}};
}

// Contacts of the default preset settle by `seat` [m] at a moment that roundings decide, and tilt a cube of 1 m by
// as much; those of exact do not. So default may miss its bars by this, check by check.
constexpr double seat = 2e-6;

inline std::vector<Expected> settling(const std::string& outcome, std::vector<std::optional<double>> reached) {
    return {{.preset = "default", .outcome = outcome, .reached = std::move(reached)},
            {.preset = "exact", .outcome = outcome}};
}

inline std::vector<Expected> with_paper(const std::string& outcome, const Expected& paper) {
    std::vector<Expected> all = of_both(outcome);
    all.push_back(paper);
    return all;
}

// The same case at 60 Hz and with 16 engine steps in each step. `make` gives it for an engine step of that length
// [s]; in the quick report it is only at 60 Hz.
template <typename Make>
void add_at_both_steps(Chapter& chapter, const Make& make) {
    constexpr double step = 1.0 / 60.0;
    constexpr int substeps = 16;
    chapter.cases.push_back(make(step));
    Case divided = make(step / substeps);
    divided.name += "-16-substeps";
    divided.options.emplace_back("substeps", std::to_string(substeps));
    divided.quick = false;
    chapter.cases.push_back(divided);
}

}  // namespace pushfactor::demos::reports::stability
