// Two folders of pictures that no run of this program has to have made.
#pragma once

#include "demos/reports/check/folder_job.h"
#include "demos/reports/check/tolerance.h"
#include "demos/reports/check/verdict.h"

namespace pushfactor::demos::reports::check {

// Compares the PNG files of two folders and of the folders below them, by name; nothing is rendered.
FolderVerdict check_pictures(const std::filesystem::path& expected, const std::filesystem::path& actual,
                             const Tolerance& tolerance, const FolderJob& job);

}  // namespace pushfactor::demos::reports::check
