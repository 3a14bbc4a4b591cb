// What all parts of a scene file have in common: names, words of a list, keys that exclude each other.
#pragma once

#include "demos/text/json_reader.h"

#include <initializer_list>
#include <string>
#include <vector>

namespace pushfactor::demos {

using Keys = std::vector<std::string>;

inline void refuse_if_given(const JsonReader& json, std::initializer_list<const char*> keys,
                            const std::string& allowed) {
    for (const char* key : keys) {
        if (json.has(key)) json.at(key).refuse(allowed);
    }
}

inline std::string read_name(const JsonReader& json) {
    std::string name = json.string();
    if (name.empty()) json.refuse("a name of at least one letter");
    return name;
}

// The value that `names` give the word.
template <typename Names>
auto read_word(const JsonReader& json, const Names& names) {
    const std::string word = json.string();
    std::string allowed;
    for (const auto& [name, value] : names) {
        if (name == word) return value;
        allowed += (allowed.empty() ? "one of " : ", ") + std::string(name);
    }
    json.refuse(allowed);
}

}  // namespace pushfactor::demos
