// Several scenes in one world.
#pragma once

#include "demos/scenes/scene_description.h"

#include <span>

namespace pushfactor::demos::scenes {

// The bodies, distances and forces of all `scenes`, in their order and where they are, under the gravity and with
// the view of the first. Names get the number of their scene in front: "2 cube 1". A static body that several
// scenes have alike (the ground) is there once. There are contacts when one of them has contacts; options, states
// and measures are left out.
SceneDescription side_by_side(const std::string& name, std::span<const SceneDescription> scenes);

}  // namespace pushfactor::demos::scenes
