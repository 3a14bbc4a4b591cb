// The measures by which cases are judged, computed from the output files of a run.
//
// Symbols: x position [m], v velocity [m/s], w angular velocity [rad/s], R orientation, I inertia in the body frame
// [kg m^2], g gravity [m/s^2], h step [s].
#pragma once

#include "demos/scenes/scene_description.h"
#include "demos/text/json.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace pushfactor::demos::reports::stability {

// A CSV file of numbers, by column; other text is NaN.
using Columns = std::map<std::string, std::vector<double>, std::less<>>;

Columns read_columns(const std::filesystem::path& file);

// Output of one run.
struct Evidence {
    const SceneDescription* scene = nullptr;
    Json summary{};
    std::map<std::string, Columns> outputs{};  // by option: "csv", "trajectory", "rows"
};

// The output option that `measure` needs besides the summary; empty for none.
std::string output_for(const std::string& measure);

// The measured value, or one per body; empty if the run does not have it.
std::vector<double> take(const std::string& measure, const Evidence& evidence);

}  // namespace pushfactor::demos::reports::stability
