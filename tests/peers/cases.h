// The scenes of the comparison: one table.
#pragma once

#include "tests/peers/cost.h"
#include "tests/peers/measures.h"

namespace pushfactor::tests::peers {

struct Ours {
    std::string name;       // "default", or the differences from it
    std::string arguments;  // of `pushfactor run`
    bool whole_steps = false;
};

struct Case {
    std::string name;
    std::string title;
    std::string arguments;  // of `pushfactor run` and `pushfactor scene`, or of `pushfactor family`
    std::size_t steps = 0;  // of 1/60 s
    Values (*measure)(const Scene&, const Run&) = nullptr;
    std::vector<Ours> ours;
    Values (*cost)(const Run&) = whole_run;
    bool family = false;                   // which of the commands prints the scene
    int pyramid = 0;                       // else: one of so many rows, see pyramid_file()
    std::string group = {};                // runs when this name or its own is asked for; none: always
    std::vector<std::string> ratios = {};  // measures that are also given as parts of those of reference settings
};

// `scenes`: the folder of the scene files that are not in the catalogue.
std::vector<Case> cases(const std::string& scenes);

// The group `piles`: heaps, towers, walls.
std::vector<Case> pile_cases();

}  // namespace pushfactor::tests::peers
