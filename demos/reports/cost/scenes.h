// What the ledger is about: every scene of the catalogue as it is, some in other sizes and at other times, and the
// same scenes with every part that there is, for the price of parts that a scene does not need.
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

// Without blanks and commas.
std::string file_name(const std::string& name);

// The scene of `description`, whose options are spelled out, with
//
//   a poke beside gravity, a distance, contacts with friction and restitution, sweep and cache,
//   the distances pushed for a single frame, so that there are two columns in every step,
//   rules that are asked before each step how long it may be.
//
// The additions are too small to be seen: forces of 1e-12 N, friction and restitution of 1e-9. Two things do
// change: bodies that only swung through each other collide, and a length error that is corrected for a single
// frame leaves no velocity.
SceneDescription with_everything(SceneDescription scene);

// The parts of a scene by name; those that it does not need are absent.
struct Parts {
    std::vector<std::string> forces;       // "gravity", "poke"
    std::vector<std::string> constraints;  // "50 distances", "contacts"
    std::vector<std::string> contacts;     // of the contact stage: "friction", "restitution", "sweep", "cache"
    std::vector<std::string> step_rules;   // that divide a step
};

Parts parts_of(const BuiltScene& scene, const Settings& settings);

}  // namespace pushfactor::demos::reports::cost
