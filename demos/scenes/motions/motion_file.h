// The motion of a moved body in a scene file.
#pragma once

#include "demos/scenes/scene_description.h"
#include "demos/text/json_reader.h"

#include <map>
#include <string>
#include <vector>

namespace pushfactor::demos {

MotionDescription read_motion(const JsonReader& json);
Json motion_json(const MotionDescription& motion);

// By object, for the test of the schema.
const std::map<std::string, std::vector<std::string>>& motion_file_keys();

}  // namespace pushfactor::demos
