// Location of the program's assets: shaders, scenes, plot scripts, page style.
#pragma once

#include <filesystem>
#include <string>

namespace pushfactor::demos {

// Path of an asset folder, such as "shaders": in the installation of the program, which may have been moved, else
// in the source tree that it was built from.
std::filesystem::path asset_folder(const std::string& name);

// The bytes of an asset. Throws OutputError for one that cannot be read.
std::string asset_text(const std::filesystem::path& file);

// Where the page that runs the program in a browser is, if it has been made: demos/live.cmake.
std::filesystem::path live_page();

}  // namespace pushfactor::demos
