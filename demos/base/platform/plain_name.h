// Texts as names of files.
#pragma once

#include <cctype>
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

}  // namespace pushfactor::demos
