// What a check found, as lines and a page for people, and as verdicts.
#pragma once

#include "demos/pages/verdict_files.h"
#include "demos/pictures/checks/verdict.h"

#include <span>
#include <string>
#include <vector>

namespace pushfactor::demos::checks {

// "goldens/stack/frame_000001.png: missing", a line per difference, failures first.
std::vector<std::string> lines_of(const FolderVerdict& folder);

// "3 of 24 pictures and 1 run differ", "24 pictures and 2 runs are as expected".
std::string headline(std::span<const FolderVerdict> folders);

// The HTML text of the page: a line per folder, the pictures that differ, the worst first, and a line for each of
// the others. Its pictures are in folders beside it. `made_with` is text. Throws OutputError as document() does.
std::string page_of(std::span<const FolderVerdict> folders, const std::string& made_with);

// One suite per folder, one case per picture and per run.
std::vector<SuiteVerdict> suites_of(std::span<const FolderVerdict> folders);

}  // namespace pushfactor::demos::checks
