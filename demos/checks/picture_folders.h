// Two folders of pictures that no run of this program has to have made.
#pragma once

#include "demos/checks/tolerance.h"
#include "demos/checks/verdict.h"

namespace pushfactor::demos::checks {

// Compares the PNG files of two folders and of the folders below them, by name; nothing is rendered.
FolderVerdict check_pictures(const std::filesystem::path& expected, const std::filesystem::path& actual,
                             const Tolerance& tolerance, const FolderJob& job);

}  // namespace pushfactor::demos::checks
