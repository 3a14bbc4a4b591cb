// Every scene that there is, in the order in which they are shown.
#pragma once

#include "demos/scenes/parameters.h"
#include "demos/scenes/scene_description.h"

#include <span>
#include <string_view>

namespace pushfactor::demos {

struct SceneEntry {
    std::string_view name;
    std::string_view sentence;  // what happens
    std::span<const Parameter> parameters;
    SceneDescription (*describe)(const ParameterValues& parameters);
};

std::span<const SceneEntry> catalogue();

// Null when there is no scene of that name.
const SceneEntry* find_scene(std::string_view name);

// What the world of a description is made of, in words: "gravity, 50 distances".
std::string made_of(const SceneDescription& description);

}  // namespace pushfactor::demos
