// Numbers from and to text. Equal numbers give equal text, and text that is no number gives nothing.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pushfactor::demos {

std::optional<double> parse_number(std::string_view text);  // finite
std::optional<int> parse_integer(std::string_view text);

// The shortest text that reads back as the same double.
std::string to_text(double value);

}  // namespace pushfactor::demos
