// The part of a scene file from which a saved run is resumed.
#pragma once

#include "demos/scenes/run_state.h"
#include "demos/scenes/scene_description.h"
#include "demos/text/json_reader.h"

#include <map>
#include <string>
#include <vector>

namespace pushfactor::demos {

// The state of a run of `scene`, whose bodies and distances have been read. Throws UsageError.
RunState read_state(const JsonReader& json, const SceneDescription& scene);

// Read back, it gives the same state, number for number.
Json state_json(const RunState& state, const SceneDescription& scene);

// The keys that the reader knows, by the part of the file.
const std::map<std::string, std::vector<std::string>>& state_file_keys();

}  // namespace pushfactor::demos
