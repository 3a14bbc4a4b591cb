// CSV files as tests read them.
#pragma once

#include "tests/texts.h"

#include <string>
#include <vector>

namespace pushfactor::tests {

// The fields of a line; commas inside quotes belong to their field.
inline std::vector<std::string> fields_of(const std::string& line) {
    std::vector<std::string> found(1);
    bool quoted = false;
    for (const char c : line) {
        if (c == '"') {
            quoted = !quoted;
        } else if (c == ',' && !quoted) {
            found.emplace_back();
        } else {
            found.back() += c;
        }
    }
    return found;
}

inline std::vector<std::vector<std::string>> table_of(const std::string& csv) {
    std::vector<std::vector<std::string>> table;
    for (const std::string& line : lines_of(csv)) table.push_back(fields_of(line));
    return table;
}

}  // namespace pushfactor::tests
