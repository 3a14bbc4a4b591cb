// Where the program finds the files that it brings along: shaders, scenes, scripts for plots.
#pragma once

#include <filesystem>
#include <string>

namespace pushfactor::demos {

// A folder of assets by its name, "shaders". That of the installation which the program is part of, wherever it has
// been moved to; without one, that of the sources which it was built from.
std::filesystem::path asset_folder(const std::string& name);

}  // namespace pushfactor::demos
