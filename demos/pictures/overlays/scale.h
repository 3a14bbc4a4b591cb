// Scales of arrows, one for a whole run.
#pragma once

#include "demos/pictures/camera/survey.h"
#include "demos/pictures/lettering.h"
#include "demos/pictures/overlays/overlay.h"

#include <vector>

namespace pushfactor::demos::pictures {

struct Scale {
    OverlayKind kind = OverlayKind::contacts;
    double units_a_metre = 1.0;  // N or m/s per metre of arrow
};

// Length of a typical arrow as a share of the distance from eye to target.
inline constexpr double typical_arrow = 0.11;

// As given, or such that a typical value of the survey makes a typical arrow in `view`.
std::vector<Scale> scales_of(const std::vector<OverlayItem>& overlay, const Survey& survey, const View& view);

// With an arrow as long as a round number of the entry's unit is at the target of `view`, in a picture of `height`
// pixels; points have none.
LegendLine legend_line(const LegendEntry& entry, const Scale& scale, const View& view, int height);

}  // namespace pushfactor::demos::pictures
