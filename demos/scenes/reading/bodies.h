// The bodies of a scene file.
#pragma once

#include "demos/scenes/reading/polyhedra.h"
#include "demos/scenes/scene_description.h"
#include "demos/text/json_reader.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace pushfactor::demos {

// All bodies so far by name, and whether they are static; constraints and forces look theirs up.
using BodyNames = std::map<std::string, bool, std::less<>>;

void read_bodies(const JsonReader& json, SceneDescription& scene, BodyNames& names, Polyhedra& polyhedra);

const std::vector<std::string>& body_keys();

}  // namespace pushfactor::demos
