// Scenes of the stability report whose files are in tests/scenes.
#pragma once

#include "demos/reports/stability/stability.h"

#include <filesystem>
#include <map>
#include <string>

namespace pushfactor::demos::reports::stability {

inline const std::filesystem::path scene_folder = std::filesystem::path(PUSHFACTOR_SOURCE_DIR) / "tests/scenes";

inline std::map<std::string, SceneDescription> scenes_with_files() {
    return {{"cone-16-directions", cubes_in_16_directions(3.0, 0.3, false)},
            {"spinning-slab", spinning_slab(3.0, 10.0, 0.3)},
            {"seam-floor", seam_floor({.speed = 4.0, .angle = 0.4})},
            {"card-house", card_house(0.3)},
            {"ball-joint-chain", ball_joint_chain(0.7)}};
}

inline std::filesystem::path file_of(const std::string& name) {
    return scene_folder / (name + ".json");
}

}  // namespace pushfactor::demos::reports::stability
