// Texts as names of files.
#pragma once

#include <cctype>
#include <set>
#include <string>
#include <string_view>

namespace pushfactor::demos {

// Letters, digits and those of `also`, with one `between` for whatever is between them: "stack of 5, landing" is
// "stack_of_5_landing".
inline std::string plain_name(std::string_view text, char between, std::string_view also = "") {
    std::string name;
    for (const char c : text) {
        const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || also.find(c) != also.npos;
        if (plain || !name.ends_with(between)) name += plain ? c : between;
    }
    return name;
}

// `wanted`, with -2, -3, ... after it if that is taken; the result is taken, too.
inline std::string unused_name(const std::string& wanted, std::set<std::string>& taken) {
    std::string name = wanted;
    for (int n = 2; !taken.insert(name).second; ++n) name = wanted + '-' + std::to_string(n);
    return name;
}

}  // namespace pushfactor::demos
