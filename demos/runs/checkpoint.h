// A run at a moment, caches included, so that it can be written down and gone on with.
#pragma once

#include "demos/runs/scene.h"
#include "demos/scenes/run_state.h"

namespace pushfactor::demos {

struct Checkpoint {
    std::vector<engine::Body> bodies;  // of the world
    RunState state;
};

// Overwrites `into`, whose memory is used again. `substeps` as of StepDivision::level().
void take_checkpoint(const BuiltScene& scene, double substeps, Checkpoint& into);

// The description whose world takes the steps that the one of `scene` takes after the checkpoint, to the last bit.
// `description` is what `scene` was built from, with every option in it.
SceneDescription resumed(SceneDescription description, const BuiltScene& scene, const Checkpoint& checkpoint);

}  // namespace pushfactor::demos
