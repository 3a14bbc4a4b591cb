// Reading of text files in tests: whole, line by line, and those of the repository.
#pragma once

#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace pushfactor::tests {

inline std::string read_file(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

// Path within the repository -> the file's text.
using Sources = std::map<std::string, std::string>;

// The files below the folders whose names have this ending.
inline Sources sources_of(std::initializer_list<const char*> folders,
                          std::initializer_list<std::string_view> endings) {
    Sources sources;
    const std::filesystem::path root(PUSHFACTOR_SOURCE_DIR);
    for (const char* const folder : folders) {
        for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
            const std::string path = std::filesystem::relative(entry.path(), root).generic_string();
            for (const std::string_view ending : endings) {
                if (path.ends_with(ending)) sources[path] = read_file(entry.path());
            }
        }
    }
    return sources;
}

// Without line ends.
inline std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

}  // namespace pushfactor::tests
