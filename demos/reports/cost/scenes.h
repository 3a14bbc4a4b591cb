// The scenes of the ledger: every scene of the catalogue, some in other sizes and at other times, and the same
// scenes with every part added, to measure the cost of parts that a scene does not need.
#pragma once

#include "demos/options/named_run.h"
#include "demos/runs/scene.h"

#include <string>
#include <vector>

namespace pushfactor::demos::reports::cost {

struct CostCase {
    std::string name;     // "funnel of 200, falling"
    std::string scene;    // of the catalogue
    OptionTexts options;  // of the command line
    double start = 0.0;   // s, simulated, when counting begins
};

std::vector<CostCase> cost_cases(bool quick);  // `quick`: the small ones

// The scene of `description`, whose options are spelled out, with
//
//   a poke beside gravity, a distance, contacts with friction and restitution, sweep and cache,
//   the distances pushed for a single frame, so that there are two columns in every step,
// rules that are evaluated before each step and may divide it.
//
// The additions are negligible: forces of 1e-12 N, friction and restitution of 1e-9. Two things do change: bodies
// that swung through each other now collide, and a length error that is corrected for a single frame leaves no
// velocity.
SceneDescription with_everything(SceneDescription scene);

// The parts of a scene by name, without absent ones.
struct Parts {
    std::vector<std::string> forces;       // "gravity", "poke"
    std::vector<std::string> constraints;  // "50 distances", "contacts"
    std::vector<std::string> contacts;     // of the contact stage: "friction", "restitution", "sweep", "cache"
    std::vector<std::string> step_rules;   // that may divide a step
};

Parts parts_of(const BuiltScene& scene, const Settings& settings);

}  // namespace pushfactor::demos::reports::cost
