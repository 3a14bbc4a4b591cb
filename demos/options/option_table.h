// What tables of options have in common: names and texts of an option, and how a text sets a member of `Target`.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace pushfactor::demos {

template <typename Target>
struct TextOption {
    std::string name;         // without the leading dashes
    std::string placeholder;  // of the value, in help texts
    std::string help;
    std::string allowed;                                             // completes "must be ..."
    std::function<bool(Target& target, std::string_view text)> set;  // false and no change for a text not allowed
    std::function<std::string(const Target& target)> get;  // a text that `set` accepts; empty if nothing is chosen
};

}  // namespace pushfactor::demos
