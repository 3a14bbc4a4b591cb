// The same scene with every part that there is, for the price of parts that a scene does not need.
#pragma once

#include "demos/scenes/scene_description.h"

namespace pushfactor::demos::reports::cost {

// The scene of `description`, whose options are spelled out, with
//
//   a poke beside gravity, a distance, contacts with friction and restitution, sweep and cache,
//   the distances pushed for a single frame, so that there are two columns in every step,
//   rules that are asked before each step how long it may be.
//
// What is added acts too little to be seen: forces of 1e-12 N, friction and restitution of 1e-9. Two things are not
// for nothing: bodies that have only swung through each other collide, and a length error that is corrected for a
// single frame leaves no velocity behind.
SceneDescription with_everything(SceneDescription scene);

}  // namespace pushfactor::demos::reports::cost
