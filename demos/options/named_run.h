// Runs given by scene name and option texts, for figures and reports.
#pragma once

#include "demos/options/choices.h"

#include <string>
#include <utility>
#include <vector>

namespace pushfactor::demos {

// Option names without dashes, and their texts as on the command line.
using OptionTexts = std::vector<std::pair<std::string, std::string>>;

// The options with `--rest off` where they say nothing else: figures and reports measure how things stand.
OptionTexts awake(OptionTexts options);

// A run of a scene of the catalogue, of a file in assets/scenes, or of the file "PATH.json".
Choices run_of(const std::string& scene, const OptionTexts& options);

// "pushfactor render stack --preset paper"
std::string command_text(const std::string& command, const std::string& scene, const OptionTexts& options);

}  // namespace pushfactor::demos
