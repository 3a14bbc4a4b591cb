// "Did you mean": the known word nearest to what somebody typed.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace pushfactor::demos {

// "; did you mean WORD?" for the nearest of `known`, or nothing when none is near.
std::string suggestion(std::string_view typed, std::span<const std::string> known);

}  // namespace pushfactor::demos
