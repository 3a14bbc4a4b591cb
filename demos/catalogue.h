// Every scene that there is, in the order in which they are shown.
#pragma once

#include "demos/parameters.h"
#include "demos/scene.h"

#include <span>
#include <string_view>

namespace pushfactor::demos {

struct SceneEntry {
    std::string_view name;
    std::string_view sentence;  // what happens
    std::string_view made_of;   // the parts of its world
    std::span<const Parameter> parameters;
    Scene (*build)(const ParameterValues& parameters, const Settings& settings);
};

std::span<const SceneEntry> catalogue();

// Null when there is no scene of that name.
const SceneEntry* find_scene(std::string_view name);

// The scene with its fallback parameters.
Scene build_scene(const SceneEntry& entry, const Settings& settings);

}  // namespace pushfactor::demos
