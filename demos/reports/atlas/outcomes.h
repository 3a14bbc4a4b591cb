// How the atlas shows the outcomes of runs.
#pragma once

#include "demos/runs/measurements.h"

#include <array>
#include <string_view>

namespace pushfactor::demos::reports::atlas {

inline constexpr std::string_view non_finite = "non-finite";

struct OutcomeLook {
    std::string_view outcome;
    std::string_view words;   // for the legend
    std::string_view colour;  // name in the palette, or #RRGGBB
    std::string_view ink;     // on that colour
};

// All outcomes of a run, from good to bad. The greys differ in lightness from all colours of the palette.
inline constexpr std::array outcome_looks{
    OutcomeLook{"rest", "rest", "green", "#111111"},
    OutcomeLook{"jitter", "jitter: shakes in place", "ivory", "#222222"},
    OutcomeLook{"creep", "creep: drifts slowly", "blue", "#ffffff"},
    OutcomeLook{"moving", "moving", "orange", "#222222"},
    OutcomeLook{"fall", "fall: came down", "vermilion", "#111111"},
    OutcomeLook{"torn", "torn: bars gave way", "#555555", "#ffffff"},
    OutcomeLook{"fly", "fly: was thrown away", "violet", "#ffffff"},
    OutcomeLook{"tunnel", "tunnel: is in the ground", "#888888", "#111111"},
    OutcomeLook{non_finite, "non-finite numbers", "#111111", "#ffffff"},
};

inline const OutcomeLook* find_look(std::string_view outcome) {
    for (const OutcomeLook& look : outcome_looks) {
        if (look.outcome == outcome) return &look;
    }
    return nullptr;
}

}  // namespace pushfactor::demos::reports::atlas
