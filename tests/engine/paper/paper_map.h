// Checks of the paper map (engine/PAPER.md) and the errata (engine/ERRATA.md): pure functions of the repository's
// texts.
#pragma once

#include "tests/texts.h"

#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pushfactor::tests {

// The names of all test cases in the .cpp files below tests/.
std::set<std::string> test_names(const Sources& sources);

// One line of the map, cells as written.
struct MapEntry {
    std::string place;   // section, equation "(6.2.9)" or "Figure 7"
    std::string says;    // in words
    std::string where;   // `path`: `name`, `name`; `path`: `name`
    std::string test;    // `name`; `name`, or why there is none
    std::string status;  // "as written", "corrected, see erratum 3" or "not used, because ..."
};

// The lines of the table under "# The paper map". A line without five cells has an empty status.
std::vector<MapEntry> map_entries(const std::string& map);

// The faults of the map and the errata, one line each; empty when there are none: - a line that names a missing
// file, or a name that is not a whole word of its code (comments do not count); - a line without a function or
// type, unless it is not used; - a line without a test, unless it is not used and gives the reason, or with a
// missing one; - a status that is none of the three, or a correction whose erratum is missing; - a place of
// `wanted` that no line has; - errata that are not numbered 1, 2, ..., have no existing test ("Test: `name`"), or
// are cited by no line.
std::vector<std::string> map_faults(const std::string& map, const std::string& errata, const Sources& sources,
                                    std::span<const std::string> wanted);

}  // namespace pushfactor::tests
