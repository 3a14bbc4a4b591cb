// The parts of a report that were asked for by name.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace pushfactor::demos::reports {

// Whether `part` is among the names that were given; without names every part is wanted.
inline bool is_wanted(const std::string& part, const std::vector<std::string>& names) {
    return names.empty() || std::find(names.begin(), names.end(), part) != names.end();
}

}  // namespace pushfactor::demos::reports
