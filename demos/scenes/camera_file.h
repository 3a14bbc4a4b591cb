// Cameras as JSON: the "camera" of a scene file, and a file of its own with the same keys.
#pragma once

#include "demos/scenes/scene_description.h"
#include "demos/text/json_reader.h"

#include <filesystem>

namespace pushfactor::demos {

// The keys that the reader knows.
std::span<const std::string> camera_keys();

// Throws UsageError, one line: the file, the path inside it, the value and what is allowed.
View read_camera(const JsonReader& json);
View read_camera_file(const std::filesystem::path& file);

// Read back, it gives the same view.
Json camera_json(const View& view);

}  // namespace pushfactor::demos
