// Texts broken into lines.
#pragma once

#include <sstream>
#include <string>
#include <vector>

namespace pushfactor::demos {

// The words of `text`, in each line as many as `fits(line)` allows, at least one.
template <typename Fits>
std::vector<std::string> wrapped(const std::string& text, const Fits& fits) {
    std::vector<std::string> lines(1);
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        std::string& line = lines.back();
        const std::string longer = line.empty() ? word : line + ' ' + word;
        if (line.empty() || fits(longer)) {
            line = longer;
        } else {
            lines.push_back(word);
        }
    }
    return lines;
}

}  // namespace pushfactor::demos
