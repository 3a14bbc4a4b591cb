// Whether the map of the paper (engine/README.md) and its errata (engine/ERRATA.md) are true: pure functions over
// the texts of the repository.
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

// One line of the map, cells as they stand there.
struct MapEntry {
    std::string place;   // section, equation "(6.2.9)" or "Figure 7"
    std::string says;    // in words
    std::string where;   // `path`: `name`, `name`; `path`: `name`
    std::string test;    // `name`; `name`, or why there is none
    std::string status;  // "as written", "corrected, see erratum 3" or "not used, because ..."
};

// The lines of the table under "## The paper map". What is not five cells has an empty status.
std::vector<MapEntry> map_entries(const std::string& map);

// What is wrong with the map and the errata, a line each; nothing when all is well:
//  - a line that names a file that is not there, or a name that is no whole word of its code (comments do not
//  count);
//  - a line without a function or type, unless it is not used;
//  - a line without a test, unless it is not used and gives the reason, or with one that is not there;
//  - a status that is none of the three, or a correction without an erratum that is there;
//  - a place of `wanted` that no line has;
//  - errata that are not numbered 1, 2, ..., have no test that is there ("Test: `name`"), or that no line cites.
std::vector<std::string> map_faults(const std::string& map, const std::string& errata, const Sources& sources,
                                    std::span<const std::string> wanted);

}  // namespace pushfactor::tests
