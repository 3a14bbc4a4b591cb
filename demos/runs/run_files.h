// The output files of a run: those written step by step, and the final state.
#pragma once

#include <optional>
#include <string>

namespace pushfactor::demos {

// Paths; "-" is standard output.
struct RunFiles {
    std::optional<std::string> csv, trajectory, rows, save_state;

    bool operator==(const RunFiles&) const = default;
};

}  // namespace pushfactor::demos
