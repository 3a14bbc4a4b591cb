// Shrinks a failing scene as far as it still fails: fewer bodies, constraints and options, less motion, rounder
// numbers.
#pragma once

#include "demos/scenes/scene_description.h"

#include <functional>

namespace pushfactor::tests {

using Fails = std::function<bool(const demos::SceneDescription&)>;

// Greedy: takes every simplification that still fails, the greatest first, until none is left or `most_tries`
// scenes were tried. `scene` itself must fail.
demos::SceneDescription shrink(demos::SceneDescription scene, const Fails& fails, int most_tries = 3000);

}  // namespace pushfactor::tests
