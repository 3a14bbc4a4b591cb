// Runs by the names of scene and options, as figures and reports list them.
#pragma once

#include "demos/options/choices.h"

#include <string>
#include <utility>
#include <vector>

namespace pushfactor::demos {

// Names without dashes, and texts, as on the command line.
using OptionTexts = std::vector<std::pair<std::string, std::string>>;

// A run of a scene of the catalogue, or of a file in assets/scenes.
Choices run_of(const std::string& scene, const OptionTexts& options);

// "pushfactor render stack --preset paper"
std::string command_text(const std::string& command, const std::string& scene, const OptionTexts& options);

}  // namespace pushfactor::demos
