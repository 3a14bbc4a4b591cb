// Comma-separated lists: "0,0.5,10".
#pragma once

#include <algorithm>
#include <string_view>
#include <vector>

namespace pushfactor::demos {

// The parts between commas, including empty ones; one empty part for an empty text.
inline std::vector<std::string_view> parts_of(std::string_view text) {
    std::vector<std::string_view> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

}  // namespace pushfactor::demos
