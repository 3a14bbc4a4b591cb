// The catalogue of scenes, in display order.
#pragma once

#include "demos/scenes/parameters.h"
#include "demos/scenes/scene_description.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pushfactor::demos {

struct SceneEntry {
    std::string_view name;
    std::string_view sentence;  // what happens
    std::span<const Parameter> parameters;
    SceneDescription (*make)(const ParameterValues& parameters);  // all but its name

    SceneDescription describe(const ParameterValues& values) const {
        SceneDescription scene = make(values);
        scene.name = name;
        return scene;
    }
};

std::span<const SceneEntry> catalogue();

// Null if there is no scene of that name.
const SceneEntry* find_scene(std::string_view name);

// Names of the parameters of all scenes, each once.
std::vector<std::string> parameter_names();

// The parts of a description in words: "50 bodies, gravity, 50 distances".
std::string made_of(const SceneDescription& description);

}  // namespace pushfactor::demos
