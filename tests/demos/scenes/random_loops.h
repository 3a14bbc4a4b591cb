// Random mechanisms whose joints close loops: rings, scissors, frames, suspensions, and linkages driven by a motor.
#pragma once

#include "demos/scenes/scene_description.h"
#include "tests/random.h"

#include <span>
#include <string_view>

namespace pushfactor::tests {

struct LoopFamily {
    std::string_view name;
    bool driven;    // by a motor
    bool anchored;  // to the world: hang() instead of drop()
    demos::SceneDescription (*make)(Random&);
};

// Their members are around the origin, at rest and without gravity.
std::span<const LoopFamily> loop_families();

// Turns the scene, lifts it above a ground, lets it spin, and adds gravity.
void drop(demos::SceneDescription& scene, Random& random);

// Turns the scene and lets it spin as one piece, without gravity, contacts and springs, whose energy belongs half a
// step after the momenta.
void set_free(demos::SceneDescription& scene, Random& random);

// Turns an anchored scene about the origin, and adds gravity.
void hang(demos::SceneDescription& scene, Random& random);

double mass_of(const demos::SceneDescription& scene);   // kg
double reach_of(const demos::SceneDescription& scene);  // m, of the corners of the bodies from the origin

}  // namespace pushfactor::tests
