// Scenes side by side: a world should cost, and move, as the sum of its parts.
#pragma once

#include "demos/scenes/scene_description.h"

#include <functional>
#include <string>
#include <vector>

namespace pushfactor::demos::reports::cost {

// Scenes that are too far apart to touch, and the simulated time from which their steps are counted.
struct Neighbours {
    std::string name;
    std::vector<SceneDescription> parts;
    std::vector<int> times;  // how often each part is there in `together`
    SceneDescription together;
    double start = 0.0;  // s
};

// Those of the report; the quick ones take seconds.
std::vector<Neighbours> neighbours(bool quick);

struct SumOfParts {
    std::string name;
    double islands = 0.0;              // mean per step, together
    double parts_us = 0.0;             // CPU time per step: the sum of all parts alone
    double together_us = 0.0;          // and of the common world
    double ratio = 0.0;                // together over sum: the median of several goes, each of all worlds in turn
    double parts_multiply_adds = 0.0;  // of the solver per step
    double together_multiply_adds = 0.0;
    double moved = 0.0;  // m: how far the first part's bodies end from where they end alone
};

// `goes` times the same steps of all worlds. Calls `check` now and then, which may throw.
SumOfParts measure(const Neighbours& scenes, int goes, const std::function<void()>& check);

}  // namespace pushfactor::demos::reports::cost
