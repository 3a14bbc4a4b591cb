// Random scenes from a seed: bodies over six decades of size and eight of mass that overlap, fly about and are
// linked to each other, with any of the simulation options.
#pragma once

#include "demos/options/settings.h"
#include "demos/scenes/scene_description.h"

#include <cstdint>

namespace pushfactor::tests {

// An ordinary scene: written to a file, `pushfactor run` accepts it. Numbers have four digits, but for
// polyhedra, which have all. The same on every platform.
demos::SceneDescription random_scene(std::uint64_t seed);

// The settings from the scene's own options. Throws std::invalid_argument for one that is not allowed.
demos::Settings settings_of(const demos::SceneDescription& scene);

}  // namespace pushfactor::tests
