// What the colours of overlays mean.
#pragma once

#include "demos/options/look_choices.h"
#include "demos/text/palette.h"

#include <string>
#include <string_view>
#include <vector>

namespace pushfactor::demos::pictures {

// Of bodies that an overlay has nothing to say of.
inline constexpr std::string_view colour_of_none = "ivory";

// A line of an overlay's legend: "contact force" or "bar force" of forces, and so on.
struct LegendEntry {
    std::string name;
    Colour colour;
    std::string unit;  // empty for points
};
std::vector<LegendEntry> entries_of(OverlayKind kind);

}  // namespace pushfactor::demos::pictures
