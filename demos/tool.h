// Other programs, which are looked for only when they are wanted: ffmpeg for videos, gnuplot for plots.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pushfactor::demos {

// Where PATH has it.
std::optional<std::filesystem::path> find_tool(const std::string& name);

// Runs `words` (the program and its arguments) to its end. Throws RunError with the last words that it wrote to its
// standard error when it is not there, does not start or ends with another status than 0.
void run_tool(const std::vector<std::string>& words);

}  // namespace pushfactor::demos
