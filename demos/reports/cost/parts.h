// What a scene was made of, by name.
#pragma once

#include "demos/runs/scene.h"

#include <string>
#include <vector>

namespace pushfactor::demos::reports::cost {

// Parts that a scene does not need are not in these lists.
struct Parts {
    std::vector<std::string> forces;       // "gravity", "poke"
    std::vector<std::string> constraints;  // "50 distances", "contacts"
    std::vector<std::string> contacts;     // of the contact stage: "friction", "restitution", "sweep", "cache"
    std::vector<std::string> step_rules;   // that divide a step
};

Parts parts_of(const BuiltScene& scene, const Settings& settings);

}  // namespace pushfactor::demos::reports::cost
