// The option --camera; without it the scene's own view is used, and of stills and comparisons a view that fits.
#pragma once

#include "demos/scenes/scene_description.h"

#include <optional>
#include <string>
#include <string_view>

namespace pushfactor::demos {

struct CameraChoice {
    std::string text{};             // as given; empty if not given
    std::optional<View> view{};     // of a camera file
    bool fit = false;               // about the same direction, as close as possible with all motion in view
    double degrees_a_second = 0.0;  // around the vertical through the target, counter-clockwise seen from above
};

// Parses "scene", "FILE", "fit", "orbit:DEGREES_PER_SECOND" or several of them separated by commas. None for other
// text; throws UsageError for a file that is not a camera.
std::optional<CameraChoice> parse_camera(std::string_view text);

// `view` after orbiting for `time` [s].
View turned(const CameraChoice& choice, View view, double time);

}  // namespace pushfactor::demos
