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

// What is fast, turns or bounces.
Chapter impacts();
Chapter passing();
Chapter turning();
Chapter bounces();
Chapter slopes();

// Bars, and scenes with little or nothing in them.
Chapter chains();
Chapter redundant_bars();
Chapter little();

// The same expectation of the presets default and exact.
inline std::vector<Expected> of_both(const std::string& outcome) {
    return {{.preset = "default", .outcome = outcome}, {.preset = "exact", .outcome = outcome}};
}

inline std::vector<Expected> with_paper(const std::string& outcome, const Expected& paper) {
    std::vector<Expected> all = of_both(outcome);
    all.push_back(paper);
    return all;
}

}  // namespace pushfactor::demos::reports::stability
