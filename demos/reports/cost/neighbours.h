// Scenes side by side: a world should cost as much as its parts, and move like them.
#pragma once

#include "demos/scenes/scene_description.h"

#include <functional>
#include <string>
#include <vector>

namespace pushfactor::demos::reports::cost {

// Scenes too far apart to touch, and the simulated time from which their steps are counted.
struct Neighbours {
    std::string name;
    std::vector<SceneDescription> parts;
    std::vector<int> times;  // number of copies of each part in `together`
    SceneDescription together;
    double start = 0.0;  // s
};

// The list of the report; `quick` takes seconds.
std::vector<Neighbours> neighbours(bool quick);

struct SumOfParts {
    std::string name;
    double islands = 0.0;              // mean per step, together
    double parts_us = 0.0;             // CPU time per step: the sum of all parts alone
    double together_us = 0.0;          // and of the common world
    double ratio = 0.0;                // together / sum: median of several passes, each over all worlds in turn
    double parts_multiply_adds = 0.0;  // of the solver per step
    double together_multiply_adds = 0.0;
    double moved = 0.0;  // m: largest distance of the first part's bodies from where they end alone
};

// Times the same steps of all worlds `goes` times. Calls `check` often, which may throw.
SumOfParts measure(const Neighbours& scenes, int goes, const std::function<void()>& check);

}  // namespace pushfactor::demos::reports::cost
