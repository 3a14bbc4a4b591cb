// Scenes as JSON files. The format is described by assets/scenes/scene.schema.json.
#pragma once

#include "demos/scenes/scene_description.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace pushfactor::demos {

// Throws UsageError, one line: the file, the path inside it, the value and what is allowed.
SceneDescription read_scene_file(const std::filesystem::path& file);

// A camera in a file of its own, with the keys of "camera" in a scene file.
View read_camera_file(const std::filesystem::path& file);

// The JSON text of a scene; read back, it gives the same description, number for number.
std::string scene_file_text(const SceneDescription& scene);

// The keys that the reader knows, by the part of the file: "scene", "body", ... The schema must know the same.
const std::map<std::string, std::vector<std::string>>& scene_file_keys();

}  // namespace pushfactor::demos
