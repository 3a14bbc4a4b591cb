// Measured motion beside a scene: bodies that follow measured poses, touch nothing, and are compared with the
// bodies of the scene that they are the motion of.
#pragma once

#include "demos/scenes/motions/pose_reader.h"
#include "demos/scenes/scene_description.h"

#include <filesystem>
#include <vector>

namespace pushfactor::demos {

// Adds the measured motion of this body, poses from 0 s on: an ivory body a little smaller than its own, which
// hides it where they agree.
void add_measured(SceneDescription& scene, std::size_t body, const std::vector<PoseLine>& poses);

// Adds that of all bodies with a mass that the trajectory has; lines of other moved bodies are passed over. Throws
// UsageError that begins with --measured for a file that is no trajectory of bodies of this scene.
void add_measured(SceneDescription& scene, const std::filesystem::path& file);

}  // namespace pushfactor::demos
