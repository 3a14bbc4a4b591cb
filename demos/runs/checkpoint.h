// Checkpoints: the state of a run including caches, from which it can be resumed.
#pragma once

#include "demos/runs/scene.h"
#include "demos/scenes/run_state.h"

namespace pushfactor::demos {

struct Checkpoint {
    std::vector<engine::Body> bodies;  // of the world
    RunState state;
};

// Overwrites `into`, reusing its memory. `parts`: StepDivision::level().
void take_checkpoint(const BuiltScene& scene, double parts, Checkpoint& into);

// Gives the parts of the scene what they remember of a run; its bodies are those of then.
void restore(BuiltScene& scene, const RunState& state);

// Takes the scene back to a checkpoint of its own.
void go_back(BuiltScene& scene, const Checkpoint& checkpoint);

// Takes over the pose of the body, and its momenta unless it is static.
void take_state(const engine::Body& body, BodyDescription& into);

// The description that resumes `scene` from the checkpoint, bit-identical to an uninterrupted run. `description` is
// what `scene` was built from, with every option spelled out.
SceneDescription resumed(SceneDescription description, const BuiltScene& scene, const Checkpoint& checkpoint);

}  // namespace pushfactor::demos
