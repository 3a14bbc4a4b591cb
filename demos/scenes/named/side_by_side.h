// Several scenes in one world.
#pragma once

#include "demos/scenes/scene_description.h"

#include <span>

namespace pushfactor::demos::scenes {

// The bodies, distances and forces of all `scenes`, in order and in place, with gravity and view of the first.
// Names are prefixed with the number of their scene: "2 cube 1". A static body that several scenes share (the
// ground) exists once. Contacts exist if any scene has them; options, states and measures are left out.
SceneDescription side_by_side(const std::string& name, std::span<const SceneDescription> scenes);

}  // namespace pushfactor::demos::scenes
