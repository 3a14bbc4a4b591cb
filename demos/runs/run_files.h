// The files that a run writes step by step, and the state at its end.
#pragma once

#include <optional>
#include <string>

namespace pushfactor::demos {

// Paths; "-" is standard output.
struct RunFiles {
    std::optional<std::string> csv, trajectory, rows, save_state;
};

}  // namespace pushfactor::demos
