// The scenes of the comparison: one table.
#pragma once

#include "tests/peers/measures.h"

namespace pushfactor::tests::peers {

struct Ours {
    std::string name;       // "default", or what differs
    std::string arguments;  // of `pushfactor run`
    bool whole_steps = false;
};

struct Case {
    std::string name;
    std::string title;
    std::string arguments;  // of `pushfactor run` and `pushfactor scene`
    std::size_t steps = 0;  // of 1/60 s
    Values (*measure)(const Scene&, const Run&) = nullptr;
    std::vector<Ours> ours;
};

// `scenes`: the folder of the files that are not in the catalogue.
std::vector<Case> cases(const std::string& scenes);

}  // namespace pushfactor::tests::peers
