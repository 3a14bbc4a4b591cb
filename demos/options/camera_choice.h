// From where a run is looked at: the scene's own view, unless somebody chose.
#pragma once

#include "demos/scenes/scene_description.h"

#include <optional>
#include <string>
#include <string_view>

namespace pushfactor::demos {

struct CameraChoice {
    std::string text{};             // as it was given; empty when it was not
    std::optional<View> view{};     // of a camera file
    bool fit = false;               // from the same direction, as near as shows all that moves, all the time
    double degrees_a_second = 0.0;  // around the vertical through the target, counter-clockwise seen from above
};

// "FILE", "fit" or "orbit:DEGREES_PER_SECOND", or some of them separated by commas. Nothing when the text is none
// of that; throws UsageError for a file that is no camera.
std::optional<CameraChoice> parse_camera(std::string_view text);

// `view` after `time` [s] of turning.
View turned(const CameraChoice& choice, View view, double time);

}  // namespace pushfactor::demos
