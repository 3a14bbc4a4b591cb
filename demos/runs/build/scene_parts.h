// Steps of building a scene (scene.h), by what they add. Internal to this folder.
#pragma once

#include "demos/runs/scene.h"

#include <string>
#include <vector>

namespace pushfactor::demos {

// Index of a body of the scene. Throws engine::InvalidInput for an unknown name.
int index_of(const std::string& name, const SceneDescription& description);

// Each adds nothing if the description has none.
void add_distances(BuiltScene& scene, const SceneDescription& description, const Settings& settings);
void add_joints(BuiltScene& scene, const SceneDescription& description, const Settings& settings);

// By body, a number that movable ones have in common which joints and bars connect, but not through static ones:
// what lies on the ground must not sink. Empty without joints.
std::vector<int> mechanisms_of(const BuiltScene& scene);

// Contacts with their friction, restitution, and pairs that they leave out.
void add_contacts(BuiltScene& scene, const SceneDescription& description, const Settings& settings);

}  // namespace pushfactor::demos
