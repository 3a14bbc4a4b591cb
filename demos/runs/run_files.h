// What a run writes: the files written step by step, the final state, and measures that are not always made.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pushfactor::demos {

// Paths; "-" is standard output.
struct RunFiles {
    std::optional<std::string> csv, trajectory, rows, errors, save_state;
    std::vector<std::string> measures;  // of the scene, which the summary is to have although they cost time

    bool operator==(const RunFiles&) const = default;
};

}  // namespace pushfactor::demos
