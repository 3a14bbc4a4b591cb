// Cameras as JSON: the "camera" of a scene file, and a file of its own with the same keys.
#pragma once

#include "demos/scenes/reading/fields.h"
#include "demos/scenes/scene_description.h"

#include <filesystem>

namespace pushfactor::demos {

void describe(Fields& fields, View& view);

// Throws UsageError, one line: the file, the path inside it, the value and what is allowed.
View read_camera(const JsonReader& json);
View read_camera_file(const std::filesystem::path& file);

}  // namespace pushfactor::demos
