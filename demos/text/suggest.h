// "Did you mean" suggestions for misspelt words.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace pushfactor::demos {

// "; did you mean WORD?" for the nearest of `known`, or empty if none is near.
std::string suggestion(std::string_view typed, std::span<const std::string> known);

}  // namespace pushfactor::demos
